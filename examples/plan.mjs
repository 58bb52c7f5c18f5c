// Plans a walk from Node.js and writes it as BVH and GLB: node examples/plan.mjs [SCENE.json]
import { readFile, writeFile } from 'node:fs/promises'
import { loadStridegraph } from '../build/wasm/stridegraph.mjs'

const scene = JSON.parse(await readFile(process.argv[2] ?? 'public/scenes/labyrinth.json', 'utf8'))
const stridegraph = await loadStridegraph()
const library = stridegraph.openLibrary(await readFile('build/library/default.sgraph'))
const walk = library.plan(scene, { seed: 7 })
console.log(`${walk.status}: ${walk.frames} frames, ${walk.report.motion_length_m.toFixed(1)} m`)
if (walk.status === 'arrived') {
  await writeFile('walk.bvh', walk.toBvh())
  await writeFile('walk.glb', walk.toGlb())
} else {
  console.log(walk.report.explanation)
}
library.delete()
