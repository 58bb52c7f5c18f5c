/** The motion-graph engine: opens or builds libraries of captured motion and plans walks through rooms. */

/** A refusal. Nothing else is thrown for bad arguments. */
export class StridegraphError extends Error {
  /** One of {@link Stridegraph.errorCodes}. */
  readonly code: string
  /** For faults in a text: its name, and line and column from 1, as far as known. */
  readonly file?: string
  readonly line?: number
  readonly column?: number
}

/** A rectangle on the floor: centre and full size, metres. */
export interface Rectangle {
  x: number
  z: number
  width: number
  depth: number
}

/** A point on the floor, metres, with or without a direction: 0 faces +z, 90 faces +x. */
export interface Placement {
  x: number
  z: number
  heading_deg?: number
}

export interface MovingObstacle {
  width: number
  depth: number
  repeat?: 'loop' | 'pingpong' | 'once'
  /** Where its centre is at a time (seconds); times grow. */
  track: { t: number; x: number; z: number }[]
}

/** A part of the floor to keep out of where that is possible, or to lead over where that costs little. */
export interface Area extends Rectangle {
  kind: 'avoid' | 'prefer'
}

/** What every walk keeps to, beyond getting there. */
export interface WalkConstraints {
  gait?: 'walk' | 'run'
  /** Metres per second, 0..10. */
  min_speed_m_s?: number
  max_speed_m_s?: number
  /** Seconds after the beginning, above 0, at most 3600. */
  latest_arrival_s?: number
  areas?: Area[]
}

/** A room that spans 0..width in x and 0..depth in z, metres. The form of the editor's files. */
export interface Scene {
  version?: number
  name?: string
  width: number
  depth: number
  obstacles: Rectangle[]
  moving?: MovingObstacle[]
  /** Of the first walker. */
  start: Placement
  goal: Placement
  /** Further walkers, at most 100. */
  walkers?: { start: Placement; goal: Placement }[]
  constraints?: WalkConstraints
  /** Of the disc that stands for the body, metres; 0.4 when missing. */
  radius?: number
  seed?: number
  /** Members this version does not know are kept. */
  [member: string]: unknown
}

export interface PlanOptions {
  /** Instead of the scene's. */
  seed?: number
  /** Instead of the scene's, metres, 0.05..5. */
  radius?: number
  /** How near the goal the search has to come, metres, 0.01..5; 0.1 when missing. The end of the walk is then
   * bent to arrive exactly. */
  goalRadius?: number
  /** Begin and end with a standing body where the library can; true when missing. */
  standing?: boolean
  /** Pin planted feet; true when missing, false leaves feet as captured and blended. */
  footCleanup?: boolean
  planner?: 'prm' | 'rrt-connect'
  /** thesis-checked leaves out edges that collide; the thesis as printed does not look at obstacles. */
  search?: 'guided' | 'thesis' | 'thesis-checked'
  /** Metres between subgoals of the thesis search, 0.2..20; 2 when missing. */
  subgoalSpacing?: number
  /** How many states the guided search looks at beyond those of the first walk to find better ones; 0 when missing.
   * 20,000 take some 20 to 50 ms. The same number gives the same walk everywhere. */
  improve?: number
  /** A walk at most so many times as long as a disc's way to the goal is not improved any further, 1..10. */
  until?: number
  /** Milliseconds for the motion search; 0 or missing means no limit. A walk that was found by then is improved
   * no further. */
  budgetMs?: number
}

export type PlanStatus =
  'arrived' | 'start_blocked' | 'goal_blocked' | 'no_path' | 'no_motion' | 'budget_spent'

/** What happened, in figures; the same members as the program's plan report. */
export interface PlanReport {
  status: PlanStatus
  seed: number
  planner: string
  search: string
  radius_m: number
  goal_radius_m: number
  units_per_metre: number
  path_ms: number
  motion_ms: number
  synthesis_ms: number
  total_ms: number
  path_length_m: number
  motion_length_m: number
  duration_s: number
  frames: number
  expansions: number
  transitions: number
  /** Steps taken from a standing pose to a near goal that no clip leads to as directly; missing where none are. */
  small_steps?: number
  /** Library frames at both ends of every edge played. */
  edges: [number, number][]
  /** Smallest distance of the disc's rim to anything along the walk. */
  clearance_m: number
  /** Likewise to anything that moves; missing where nothing does. */
  moving_clearance_m?: number
  /** When something that moves first touches the body where it stands at the end; missing where nothing does. */
  goal_free_until_s?: number
  /** Share of the walk that keeps to the gait and speed asked for; missing where none is. */
  constraints_kept?: number
  foot_skate_cm_s: number
  /** The same of the clips that the library is made of. */
  foot_skate_source_cm_s: number
  /** How far the lowest foot joint sinks below the clips' floors. */
  penetration_cm: number
  /** Stances of all feet that were pinned to one place. */
  contacts: number
  /** How far planted feet were moved. */
  feet_corrected: { mean_cm: number; worst_cm: number }
  /** Joints on the floor above which no leg could be made out. */
  feet_left_alone: string[]
  /** Fastest turn of a joint over what it does at most in the clips (its 99.9th percentile), and where. */
  joint_speed_ratio: number
  joint_speed_ratio_at: { frame: number; joint: string }
  /** Likewise the quickest change of a turn. */
  joint_accel_ratio: number
  joint_accel_ratio_at: { frame: number; joint: string }
  /** Every transition: its first frame of the walk, the library frames at its ends, its distance. */
  seams: { frame: number; from: number; to: number; distance_m: number }[]
  /** From the last root to the goal, over the floor. */
  arrival_error_m: number
  /** From the last facing to the heading asked for at the goal, if any was. */
  arrival_heading_error_deg?: number
  /** How the end of the walk was bent to arrive: over its last metres, at most so much. */
  arrival_warp: { last_m: number; stretch: number; deg_per_m: number }
  /** Share of the walk's frames whose way is bent a little from the captured one, 0..1. */
  bent_share: number
  starts_standing: boolean
  ends_standing: boolean
  library_hash: string
  [member: string]: unknown
}

export interface Joint {
  name: string
  /** Index of the parent, which comes before its children; -1 for the root. */
  parent: number
  /** The end of a bone that has no further joint; never rotates. */
  isEndSite: boolean
  /** From the parent, in the parent's axes, metres. */
  offset: [number, number, number]
}

/** A plan, and the walk when it arrived. Plain values that outlive the library. */
export interface Walk {
  readonly status: PlanStatus
  /** Of Library.replan: the walk under way still holds and goes on as it was. */
  readonly kept: boolean
  readonly report: PlanReport
  readonly fps: number
  /** 0 unless arrived. */
  readonly frames: number
  readonly joints: Joint[]
  /** frames x joints x (x, y, z): world positions, metres, y up. */
  readonly positions: Float32Array
  /** frames x joints x (w, x, y, z): rotations relative to the parent. */
  readonly rotations: Float32Array
  /** One for each frame: 1 where a transition blends, 0 where the frame is as captured. */
  readonly blended: Uint8Array
  /** One for each frame: a bit for each entry of LibraryInfo.contactJoints that touches the floor. */
  readonly contacts: Uint8Array
  /** x, z of every corner of the path from start to goal; empty when there is none. In a scene with areas the way
   * that heeds them. */
  readonly path: Float32Array
  /** x, z of every subgoal. */
  readonly subgoals: Float32Array
  /** x, z, x, z of every edge of the roadmap, or of both trees. */
  readonly roadmap: Float32Array
  /** The walks of the scene's further walkers, in their order. */
  readonly others: Walk[]
  /** The walk with the names, channels, unit and axes of the clips it came from. Throws unless arrived. */
  toBvh(): string
  /** The walk as binary glTF 2.0. Throws unless arrived. */
  toGlb(): Uint8Array
  /** The walks of this walker and of the others, as many as arrive, in one file: below nodes "walker_1", "walker_2",
   * ..., moved by one animation. Of a single one the same as toGlb. Throws where nobody arrives. */
  allToGlb(): Uint8Array
}

export interface LibraryInfo {
  /** 16 hexadecimal digits; the same library has the same hash everywhere. */
  hash: string
  fps: number
  frames: number
  nodes: number
  clipPieces: number
  transitions: number
  thresholdMetres: number
  transitionFrames: number
  mirror: boolean
  license: string
  clips: { name: string; firstFrame: number; frames: number; mirrored: boolean }[]
  /** Joints that may touch the floor, in the order of a walk's contact bits. */
  contactJoints: number[]
}

export interface Warning {
  message: string
  /** Empty when unknown. */
  file: string
  /** From 1; 0 when unknown. */
  line: number
  column: number
  /** What it is about: warnings may be grouped by it. */
  topic: WarningTopic
}

export type WarningTopic =
  | 'other'
  | 'text'
  | 'rows'
  | 'time'
  | 'travel'
  | 'skeleton'
  | 'unit'
  | 'up_axis'
  | 'motion'
  | 'graph'
  | 'scene'

/** What building found, kept and dropped, and why. */
export interface BuildReport {
  /** Pairs of frames compared now; what a library that was appended to knew is not among them. */
  framePairs: number
  nodesBeforePruning: number
  clipPiecesBeforePruning: number
  transitionsBeforePruning: number
  nodes: number
  clipPieces: number
  transitions: number
  /** After pruning: more than `transitions` where mostTransitions left some out. */
  transitionsBeforeThinning: number
  /** Of all frames, 0..1. */
  survivingShare: number
  clips: { name: string; frames: number; transitions: number; survivingFrames: number; reason: string }[]
  warnings: Warning[]
}

/** A motion library. It holds memory that a garbage collector does not see: delete it when done. */
export interface Library {
  readonly info: LibraryInfo
  readonly joints: Joint[]
  /** What was odd about the clips when they were read and connected; kept in the .sgraph. */
  readonly notes: Warning[]
  /** Only of libraries built here. */
  readonly buildReport?: BuildReport
  /** Plans a walk. That there is no way is a status, not an error. The scene may be its JSON text. */
  plan(scene: Scene | string, options?: PlanOptions): Walk
  /** Plans onward for the last walk that arrived, while it plays: it stays as it was until `atSeconds`, and goes
   * on from that pose in the scene as it is now. A walk that still holds is kept. A walk that does not arrive
   * leaves the one under way as it was. */
  replan(scene: Scene | string, atSeconds: number, options?: PlanOptions): Walk
  /** Plans a walk that is there at once, and gets better step by step as far as `improve` allows, under the caller's
   * control. What plan() gives is what is there in the end. */
  startPlan(scene: Scene | string, options?: PlanOptions): PlanInProgress
  /** The same onward for the last walk that arrived. */
  startReplan(scene: Scene | string, atSeconds: number, options?: PlanOptions): PlanInProgress
  /** Plans a walk, and better ones as far as `improve` allows, in slices between which the page stays alive. Resolves
   * with the best. */
  planAsync(scene: Scene | string, options?: PlanOptions, run?: AsyncPlan): Promise<Walk>
  /** .sgraph bytes. */
  toBytes(): Uint8Array
  /** Frees the library; walks planned with it stay. May be called twice. */
  delete(): void
}

/** How the lengths and axes of BVH files are understood. */
export interface ReadingOptions {
  /** Of the file's lengths; a number is metres per unit. Inferred when missing or auto. */
  units?: 'auto' | 'm' | 'cm' | 'in' | number
  /** The axis that points up. Inferred when missing or auto. */
  up?: 'auto' | 'y' | 'z'
}

/** A clip as BVH text; the name is used in messages and reports. Its units and up go before those of the call. */
export interface BvhText extends ReadingOptions {
  name: string
  text: string
}

/** A clip as the bytes of a BVH file: their encoding is told from themselves, as the program does it. */
export interface BvhBytes extends ReadingOptions {
  name: string
  bytes: ArrayBuffer | ArrayBufferView
}

export type BvhClip = BvhText | BvhBytes

/** What a clip is, and how it was understood. */
export interface ClipInspection {
  name: string
  joints: Joint[]
  frames: number
  fps: number
  seconds: number
  /** Units of the file in a metre: 100 for centimetres. */
  unitsPerMetre: number
  /** How surely the unit was inferred, 0..1; 1 when it was given. */
  unitConfidence: number
  up: 'y' | 'z'
  upConfidence: number
  /** What was guessed so unsurely that a person should be asked; the topics of the warnings about it. */
  doubts: ('unit' | 'up_axis')[]
  /** From the lowest joint to the highest, most of the time or with all joints at rest, whichever is more; metres. */
  heightMetres: number
  warnings: Warning[]
}

/** What is odd about a scene that can be used. */
export interface SceneInspection {
  warnings: Warning[]
}

export interface BuildOptions extends ReadingOptions {
  /** Largest distance along a transition, metres per joint; 0.05 when missing. */
  threshold?: number
  /** Length of a transition, frames, 2..120; 13 when missing. */
  transitionFrames?: number
  /** Rate of the library, 1..240; 30 when missing. */
  fps?: number
  /** Also every clip with left and right swapped. */
  mirror?: boolean
  /** Of transitions within so many frames of each other only the best is kept, 0..100; 6 when missing. */
  neighbours?: number
  /** How many times longer one side of a transition may be than the other, 1..2; 1.5 when missing. */
  spanRatio?: number
  /**
   * Of a library with more transitions so many are kept, spread over all that its clips show, 1000 or more; 15000 when
   * missing.
   */
  mostTransitions?: number
  /**
   * .sgraph bytes of a library to go on from: its clips come first and only new frames are compared. It keeps its
   * settings, so that none of the above may be given, and its license unless there is another. The result is the
   * same, byte for byte, as building from all clips at once.
   */
  append?: ArrayBuffer | ArrayBufferView
  /** A line on where the clips come from and on what terms. */
  license?: string
}

/** A library that is being built. Ends with finish() or cancel(). */
export interface LibraryBuild {
  /** 0..1. */
  readonly progress: number
  /** Pairs of frames compared so far. */
  readonly framePairs: number
  /** Some milliseconds of work; false when nothing is left but finish(). */
  step(): boolean
  /** The library; does the steps that are left. */
  finish(): Library
  /** Gives the memory back; nothing may be called afterwards. */
  cancel(): void
}

/** How long work is done in slices. */
export interface AsyncRun {
  /** Called between slices with 0..1. */
  onProgress?: (progress: number) => void
  /** Aborting rejects with the signal's reason. */
  signal?: AbortSignal
  /** Work between two pauses, milliseconds; 12 when missing. */
  sliceMs?: number
}

export interface AsyncPlan extends AsyncRun {
  /** Called with the first walk at once, and with every better one. */
  onWalk?: (walk: Walk) => void
}

/** A plan that gets better. Ends with finish() or cancel(). */
export interface PlanInProgress {
  /** The best walk so far, or why there is none; another object whenever there is a better one. */
  readonly walk: Walk
  /** How much of `improve` is used up, 0..1; 1 when nothing is left to be done. */
  readonly progress: number
  /** Some milliseconds of work; false when nothing is left but finish(). */
  step(): boolean
  /** The best walk, with a report of the whole search; does the steps that are left. */
  finish(): Walk
  /** Gives the memory back; nothing may be called afterwards. */
  cancel(): void
}

export interface LinkOptions {
  /** Name of the motion search; guided when missing. */
  search?: 'guided' | 'thesis' | 'thesis-checked'
  /** LibraryInfo.hash of the library it was planned with. */
  libraryHash?: string
}

export interface SharedScene {
  scene: Scene
  search: string
  /** Null when unknown. */
  libraryHash: string | null
}

export interface Stridegraph {
  /** Every code that a StridegraphError may have. */
  readonly errorCodes: readonly string[]
  /** Size of the WebAssembly memory, and how much of it is in use. */
  readonly memory: { heapBytes: number; usedBytes: number }
  /** Opens .sgraph bytes, which are verified. */
  openLibrary(bytes: ArrayBuffer | ArrayBufferView): Library
  /** Reads a clip without building anything: what it holds, and what to ask about before building. */
  inspectClip(clip: BvhClip, options?: ReadingOptions): ClipInspection
  /** Reads a scene without planning anything: which of its members are misspelt, unknown or given twice. */
  inspectScene(scene: Scene | string): SceneInspection
  /** Builds a library at once. */
  buildLibrary(clips: BvhClip[], options?: BuildOptions): Library
  /** Builds a library step by step, under the caller's control. */
  startBuild(clips: BvhClip[], options?: BuildOptions): LibraryBuild
  /** Builds a library in slices between which the page stays alive. */
  buildLibraryAsync(clips: BvhClip[], options?: BuildOptions, run?: AsyncRun): Promise<Library>
  /** The fragment of a link, without '#': everything that replays the same walk anywhere. */
  encodeLink(scene: Scene | string, options?: LinkOptions): string
  /** Reads a fragment, with or without '#'. */
  decodeLink(text: string): SharedScene
}

export interface LoadOptions {
  /** The bytes of stridegraph_module.wasm, when they are there already. */
  wasmBinary?: ArrayBuffer | ArrayBufferView
  /** Where stridegraph_module.wasm is, when not beside stridegraph.mjs. */
  wasmUrl?: string | URL
}

/** Loads the engine, in browsers, workers and Node.js 18 or newer. */
export function loadStridegraph(options?: LoadOptions): Promise<Stridegraph>
