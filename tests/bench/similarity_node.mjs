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

/** Builds a library; the pairs of frames, the time of the steps that compared them, and the longest of these. */
function compareAll(engine, clips) {
  const build = engine.startBuild(clips)
  let ms = 0
  let longestStepMs = 0
  for (let more = true, pairs = 0; more; pairs = build.framePairs) {
    const begin = performance.now()
    more = build.step()
    const stepMs = performance.now() - begin
    if (build.framePairs === pairs) continue
    ms += stepMs
    longestStepMs = Math.max(longestStepMs, stepMs)
  }
  const pairs = build.framePairs
  build.cancel()
  return { pairs, ms, longestStepMs }
}

const { description, clips } = clipsOf(program)
const engine = await loadStridegraph()
const runs = Array.from({ length: turns }, () => compareAll(engine, clips))
const perSecond = ({ pairs, ms }) => (1000 * pairs) / ms
const best = runs.reduce((a, b) => (perSecond(a) > perSecond(b) ? a : b))
const table = {
  joints: description.joints,
  window: description.window,
  framePairs: best.pairs,
  pairsPerSecond: { rowsAndScan: perSecond(best), rowsAndScanFirstTime: perSecond(runs[0]) },
  longestStepMs: best.longestStepMs,
}
console.log(JSON.stringify(table, null, 2))
