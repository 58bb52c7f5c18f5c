// Measures guided walks in Node.js with the WebAssembly module, in the form that `stridegraph bench --join` reads.
// Run from the top folder after ./run build:
//   node tools/bench/node_bench.mjs --maps FOLDER --random FOLDER --graph FILE.sgraph... [--seeds 20] [--goal-radius 0.1]
//     [--repeats 1] -o FILE.json
// --random takes the folder that `stridegraph bench --random SEED --write-scenes FOLDER` wrote.

import { readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import { parseArgs } from 'node:util'
import { loadStridegraph } from '../../build/wasm/stridegraph.mjs'
import { edgesHash } from './edges_hash.mjs'

const usage = 'expected --graph FILE.sgraph (once or more), -o FILE.json, and --maps or --random FOLDER'
const { values } = parseArgs({
  options: {
    maps: { type: 'string' },
    random: { type: 'string' },
    graph: { type: 'string', multiple: true, default: [] },
    seeds: { type: 'string', default: '20' },
    'goal-radius': { type: 'string', default: '0.1' },
    repeats: { type: 'string', default: '1' },
    output: { type: 'string', short: 'o' },
  },
})
if (!values.output || values.graph.length === 0 || !(values.maps || values.random)) {
  console.error(`node_bench: ${usage}`)
  process.exit(2)
}
const goalRadius = Number(values['goal-radius'])
const repeats = Number(values.repeats)
const seeds = Array.from({ length: Number(values.seeds) }, (_, i) => i + 1)

/** All scenes of a folder, by name. */
function readRooms(set, folder) {
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'))
  return names.sort().map((name) => ({
    set,
    room: basename(name, '.json'),
    scene: readFileSync(join(folder, name), 'utf8'),
  }))
}

function measureOnce(library, scene, seed) {
  const walk = library.plan(scene, { seed, goalRadius })
  const { report } = walk
  return {
    seed: report.seed,
    status: walk.status,
    explanation: report.explanation,
    goal_radius_m: report.goal_radius_m,
    path_ms: report.path_ms,
    motion_ms: report.motion_ms,
    synthesis_ms: report.synthesis_ms,
    total_ms: report.total_ms,
    expansions: report.expansions,
    length_m: report.motion_length_m,
    duration_s: report.duration_s,
    transitions: report.transitions,
    blended_share: walk.frames > 0 ? walk.blended.reduce((sum, bit) => sum + bit, 0) / walk.frames : 0,
    clearance_m: report.clearance_m,
    arrival_error_m: report.arrival_error_m,
    edges: edgesHash(report.edges),
  }
}

/** The quickest of some runs that are alike but for their times. */
function measure(library, scene, seed) {
  const runs = Array.from({ length: repeats }, () => measureOnce(library, scene, seed))
  return runs.reduce((best, run) => (run.total_ms < best.total_ms ? run : best))
}

/** V8 compiles what is hot better after a while: what is measured is the module as it is after that. */
function warmUp(library, rooms) {
  for (const seed of [101, 102]) {
    for (const { scene } of rooms.slice(0, 10)) library.plan(scene, { seed, goalRadius })
  }
}

const engine = await loadStridegraph()
const maps = values.maps ? readRooms('maps', values.maps) : []
const randomRooms = values.random ? readRooms('random', values.random) : []
const runs = []
for (const path of values.graph) {
  const library = engine.openLibrary(readFileSync(path))
  const place = { place: 'node', library: basename(path, '.sgraph'), method: 'guided' }
  const note = (set, room, run) => runs.push({ ...place, set, room, ...run })
  warmUp(library, [...maps, ...randomRooms])
  for (const { set, room, scene } of maps) {
    for (const seed of seeds) note(set, room, measure(library, scene, seed))
  }
  for (const { set, room, scene } of randomRooms) note(set, room, measure(library, scene))
  library.delete()
  console.error(`${place.library}: ${maps.length} maps, ${randomRooms.length} random rooms in Node.js`)
}
writeFileSync(values.output, `${JSON.stringify({ runs }, null, 1)}\n`)
