// How many pairs of frames are compared in a second by the WebAssembly module in Node.js, with the search for
// transitions and step by step, as a page does it; JSON like that of similarity_bench, whose clips it takes.
//   node tests/bench/similarity_node.mjs [build/release/bench/similarity_bench]
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { loadStridegraph } from '../../build/wasm/stridegraph.mjs'

const turns = 20
const program = process.argv[2] ?? 'build/release/bench/similarity_bench'

/** The clips of the native program, and what it says of them. */
function clipsOf(bench) {
  const folder = mkdtempSync(join(tmpdir(), 'similarity-'))
  try {
    const description = JSON.parse(execFileSync(bench, ['--clips', folder], { encoding: 'utf8' }))
    const clips = Array.from({ length: description.clips }, (_, index) => ({
      name: `clip ${index}`,
      text: readFileSync(join(folder, `${index}.bvh`), 'utf8'),
    }))
    return { description, clips }
  } finally {
    rmSync(folder, { recursive: true })
  }
}

/** Builds a library: the milliseconds of each step that compared frames, and how many pairs these were. */
function compareAll(engine, clips, options) {
  const build = engine.startBuild(clips, options)
  const stepMs = []
  for (let more = true, pairs = 0; more; pairs = build.framePairs) {
    const begin = performance.now()
    more = build.step()
    const ms = performance.now() - begin
    if (build.framePairs > pairs) stepMs.push(ms)
  }
  const pairs = build.framePairs
  build.cancel()
  return { pairs, stepMs }
}

const sum = (numbers) => numbers.reduce((a, b) => a + b, 0)

/** Of many turns, which all take the same steps, the least time of each: other programs can only add to it. */
function measure(engine, clips, options) {
  const runs = Array.from({ length: turns }, () => compareAll(engine, clips, options))
  const [{ pairs, stepMs }] = runs
  const leastMs = stepMs.map((_, step) => Math.min(...runs.map((run) => run.stepMs[step])))
  return { pairs, perSecond: (1000 * pairs) / sum(leastMs), longestStepMs: Math.max(...leastMs) }
}

const { description, clips } = clipsOf(program)
const engine = await loadStridegraph()
const whole = measure(engine, clips, {})
// Where no distance is under the threshold, there is nothing to search.
const rows = measure(engine, clips, { threshold: 1e-6 })
const table = {
  joints: description.joints,
  window: description.window,
  framePairs: whole.pairs,
  pairsPerSecond: { rows: rows.perSecond, rowsAndScan: whole.perSecond },
  longestStepMs: whole.longestStepMs,
}
console.log(JSON.stringify(table, null, 2))
