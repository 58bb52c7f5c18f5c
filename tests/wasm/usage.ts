// A use of everything in stridegraph.d.ts, for the type checker alone; it is never run.
import {
  loadStridegraph,
  StridegraphError,
  type BuildReport,
  type ClipInspection,
  type Scene,
  type Walk,
} from '../../build/wasm/stridegraph.mjs'

const scene: Scene = {
  version: 1,
  width: 8,
  depth: 8,
  obstacles: [{ x: 4, z: 4, width: 1, depth: 2 }],
  moving: [{ width: 1, depth: 1, repeat: 'loop', track: [{ t: 0, x: 1, z: 5 }] }],
  start: { x: 2, z: 4, heading_deg: 90 },
  goal: { x: 6, z: 4 },
  walkers: [{ start: { x: 6, z: 2 }, goal: { x: 2, z: 6, heading_deg: 0 } }],
  constraints: {
    gait: 'walk',
    min_speed_m_s: 0.5,
    max_speed_m_s: 1.6,
    latest_arrival_s: 20,
    areas: [{ x: 3, z: 6, width: 1, depth: 1, kind: 'avoid' }],
  },
}

export async function useEverything(bytes: ArrayBuffer, signal: AbortSignal): Promise<Uint8Array> {
  const sg = await loadStridegraph({ wasmUrl: new URL('https://example.org/stridegraph_module.wasm') })
  const library = sg.openLibrary(bytes)
  const clip = { name: 'walk.bvh', text: 'HIERARCHY' }
  const mine = sg.buildLibrary([clip], { threshold: 0.05, units: 'cm', up: 'y', mirror: true })
  const report: BuildReport | undefined = mine.buildReport
  console.log(report?.survivingShare, report?.warnings[0]?.line)

  const file = { name: 'walk.bvh', bytes, up: 'z' as const }
  const { doubts, joints, heightMetres }: ClipInspection = sg.inspectClip(file, { units: 'auto' })
  console.log(doubts.includes('unit'), joints[0]?.name, heightMetres, mine.notes[0]?.topic)
  console.log(sg.inspectScene(scene).warnings[0]?.message)
  const build = sg.startBuild([clip, file], { units: 0.01 })
  while (build.step()) console.log(build.progress)
  build.finish().delete()
  const onProgress = (progress: number) => console.log(progress)
  const other = await sg.buildLibraryAsync([clip], { fps: 60 }, { onProgress, signal, sliceMs: 8 })
  other.delete()

  const walk: Walk = library.plan(scene, { seed: 1, planner: 'prm', search: 'guided', budgetMs: 100 })
  const plan = library.startPlan(scene, { improve: 20000, until: 1.02 })
  while (plan.progress < 0.5 && plan.step()) console.log(plan.walk.report.motion_length_m)
  plan.cancel()
  library.startReplan(scene, 1.5).finish()
  const onWalk = (better: Walk) => console.log(better.frames)
  await library.planAsync(scene, { improve: 1e5 }, { onWalk, onProgress, signal, sliceMs: 8 })
  const firstHeight: number | undefined = walk.positions[1]
  const edges: [number, number][] = walk.report.edges
  const others: readonly Walk[] = walk.others
  console.log(others[0]?.positions.length, others[0]?.toBvh().length, others[0]?.toGlb().length)
  console.log(firstHeight, edges.length, walk.joints[0]?.name, walk.path.length, library.info.hash)
  const { scene: shared, libraryHash } = sg.decodeLink(sg.encodeLink(scene, { search: 'thesis' }))
  const hash: string | null = libraryHash
  console.log(shared.width, hash, sg.errorCodes[0], sg.memory.heapBytes, walk.toBvh().length)
  try {
    library.plan('{}')
  } catch (reason) {
    if (reason instanceof StridegraphError) console.log(reason.code, reason.file, reason.line, reason.column)
  }
  // @ts-expect-error: a clip without text or bytes
  sg.inspectClip({ name: 'walk.bvh' })
  // @ts-expect-error: an unknown planner
  library.plan(scene, { planner: 'a-star' })
  // @ts-expect-error: an unknown gait
  library.plan({ ...scene, constraints: { gait: 'swim' } })
  // @ts-expect-error: a scene without a room
  library.plan({ start: { x: 0, z: 0 }, goal: { x: 1, z: 1 } })
  // @ts-expect-error: a figure that is read only
  walk.frames = 3
  mine.delete()
  library.delete()
  return walk.others.length > 0 ? walk.allToGlb() : walk.toGlb()
}
