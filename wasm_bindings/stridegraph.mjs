// The engine for JavaScript: the same file in browsers, workers and Node.js. Types and meanings are in
// stridegraph.d.ts. Everything here copies in and out of WebAssembly; only a library (and a build or a plan that
// is under way) holds on to memory there.
import createStridegraphModule from './stridegraph_module.mjs'
import { Handle, bytesOf, clipOf, refuse, sceneTextOf, textOf, unpack } from './stridegraph_values.mjs'

export { StridegraphError } from './stridegraph_values.mjs'

/** A planned walk: plain values, independent of the library it came from. */
class Walk {
  #module
  #skeleton
  #motion

  constructor(module, skeleton, plan, walker = 0) {
    this.#module = module
    this.#skeleton = skeleton
    this.#motion = { walker, fps: plan.fps, rootPositions: plan.rootPositions, rotations: plan.rotations }
    this.status = plan.status
    this.report = JSON.parse(plan.report)
    this.fps = plan.fps
    this.frames = plan.frames
    this.kept = plan.kept
    this.joints = skeleton.joints
    this.positions = plan.positions
    this.rotations = Float32Array.from(plan.rotations)
    this.blended = plan.blended
    this.contacts = plan.contacts
    this.path = plan.path
    this.subgoals = plan.subgoals
    this.roadmap = plan.roadmap
    this.others = plan.others.map((other, i) => new Walk(module, skeleton, other, i + 1))
  }

  toBvh() {
    this.#mustHaveFrames()
    return unpack(this.#module.walkToBvh(this.#skeleton, this.#motion))
  }

  toGlb() {
    this.#mustHaveFrames()
    return unpack(this.#module.walksToGlb(this.#skeleton, [this.#motion]))
  }

  allToGlb() {
    const arrived = [this, ...this.others].filter(({ frames }) => frames > 0)
    if (arrived.length === 0) this.#mustHaveFrames()
    const motions = arrived.map((walk) => walk.#motion)
    return unpack(this.#module.walksToGlb(this.#skeleton, motions))
  }

  #mustHaveFrames() {
    if (this.frames > 0) return
    unpack(
      this.#module.invalidArgument(`the plan ended with ${this.status}, expected one that arrived to export`),
    )
  }
}

/** A motion library. Delete it when done. */
class Library {
  #module
  #handle
  #info
  #skeleton
  #notes

  constructor(module, raw, buildReport) {
    this.#module = module
    this.#handle = new Handle(module, raw, 'library')
    this.#info = raw.info()
    this.#skeleton = raw.skeleton()
    this.#notes = raw.notes()
    this.buildReport = buildReport
  }

  get info() {
    return structuredClone(this.#info)
  }

  get joints() {
    return structuredClone(this.#skeleton.joints)
  }

  get notes() {
    return structuredClone(this.#notes)
  }

  startPlan(scene, options) {
    return this.#started(this.#handle.raw.startPlan(sceneTextOf(this.#module, scene), options))
  }

  startReplan(scene, atSeconds, options) {
    const raw = this.#handle.raw
    if (typeof atSeconds !== 'number') refuse(this.#module, 'atSeconds', atSeconds, 'a number of seconds')
    return this.#started(raw.startReplan(sceneTextOf(this.#module, scene), atSeconds, options))
  }

  #started(answer) {
    return new PlanInProgress(this.#module, this.#skeleton, unpack(answer))
  }

  plan(scene, options) {
    return this.startPlan(scene, options).finish()
  }

  replan(scene, atSeconds, options) {
    return this.startReplan(scene, atSeconds, options).finish()
  }

  async planAsync(scene, options, { onWalk, ...run } = {}) {
    run.signal?.throwIfAborted()
    const plan = this.startPlan(scene, options)
    let shown
    const show = () => {
      if (plan.walk !== shown) onWalk?.((shown = plan.walk))
    }
    show()
    return inSlices(plan, run, show)
  }

  toBytes() {
    return this.#handle.raw.toBytes()
  }

  delete() {
    this.#handle.delete()
  }
}

/** A plan of which there is a walk, and which gets better step by step. */
class PlanInProgress {
  #module
  #skeleton
  #handle
  #walk
  #stepped = false

  constructor(module, skeleton, raw) {
    this.#module = module
    this.#skeleton = skeleton
    this.#handle = new Handle(module, raw, 'plan')
  }

  get walk() {
    this.#walk ??= new Walk(this.#module, structuredClone(this.#skeleton), this.#handle.raw.walk())
    return this.#walk
  }

  get progress() {
    return this.#handle.raw.progress()
  }

  /** Some milliseconds of work; false when nothing is left but finish(). */
  step() {
    const raw = this.#handle.raw
    if (raw.isDone()) return false
    this.#stepped = true
    if (raw.step()) this.#walk = undefined
    return !raw.isDone()
  }

  finish() {
    try {
      while (this.step());
      // The last walk's report tells of the whole search.
      if (this.#stepped) this.#walk = undefined
      return this.walk
    } finally {
      this.cancel()
    }
  }

  cancel() {
    this.#handle.delete()
  }
}

/** How much of a build's progress the reading of its clips counts for. */
const readingShare = 0.2

/** A library that is being built, step by step. */
class LibraryBuild {
  #module
  #handle
  #waiting
  #clipCount
  #started = false
  #ready = false

  constructor(module, clips, options) {
    this.#module = module
    if (!Array.isArray(clips)) {
      refuse(module, 'the list of clips', clips, 'an array of {name, text} or {name, bytes}')
    }
    // Copied at once: whoever asked for a build may use the bytes otherwise before their turn comes.
    this.#waiting = clips.map((clip, index) => {
      const { bytes, ...rest } = clipOf(module, `clip ${index}`, clip)
      return { ...rest, bytes: bytes.slice() }
    })
    this.#clipCount = this.#waiting.length
    const append = options?.append ?? undefined
    const base = append === undefined ? undefined : bytesOf(module, 'the library', append)
    this.#handle = new Handle(module, unpack(module.Builder.create(options, base)), 'build')
  }

  get progress() {
    const read = this.#clipCount === 0 ? 1 : 1 - this.#waiting.length / this.#clipCount
    return readingShare * read + (1 - readingShare) * this.#handle.raw.progress()
  }

  get framePairs() {
    return this.#handle.raw.framePairs()
  }

  /** Some milliseconds of work; false when nothing is left but finish(). */
  step() {
    const raw = this.#handle.raw
    const clip = this.#waiting.shift()
    if (clip) {
      unpack(raw.addClip(clip))
      return true
    }
    if (!this.#started) {
      unpack(raw.start())
      this.#started = true
      return true
    }
    this.#ready = !raw.step()
    return !this.#ready
  }

  finish() {
    while (!this.#ready) this.step()
    try {
      const { library, report } = unpack(this.#handle.raw.finish())
      return new Library(this.#module, library, report)
    } finally {
      this.cancel()
    }
  }

  cancel() {
    this.#handle.delete()
  }
}

const pause = () => new Promise((resolve) => setTimeout(resolve, 0))

/** Finishes a build or a plan in slices before which others have their turn. */
async function inSlices(work, { onProgress, signal, sliceMs = 12 }, onSlice) {
  try {
    for (let more = true; more;) {
      await pause()
      signal?.throwIfAborted()
      const end = performance.now() + sliceMs
      do more = work.step()
      while (more && performance.now() < end)
      onSlice?.()
      onProgress?.(work.progress)
    }
    signal?.throwIfAborted()
    return work.finish()
  } finally {
    work.cancel()
  }
}

/** The engine, loaded. */
class Stridegraph {
  #module
  #heap

  constructor(module, heap) {
    this.#module = module
    this.#heap = heap
    this.errorCodes = Object.freeze(module.errorCodes())
  }

  get memory() {
    return { heapBytes: this.#heap().byteLength, usedBytes: this.#module.usedBytes() }
  }

  openLibrary(bytes) {
    return new Library(
      this.#module,
      unpack(this.#module.Library.open(bytesOf(this.#module, 'the library', bytes))),
    )
  }

  inspectClip(clip, options) {
    return unpack(this.#module.inspectClip(clipOf(this.#module, 'the clip', clip), options))
  }

  inspectScene(scene) {
    return unpack(this.#module.inspectScene(sceneTextOf(this.#module, scene)))
  }

  startBuild(clips, options) {
    return new LibraryBuild(this.#module, clips, options)
  }

  buildLibrary(clips, options) {
    const build = this.startBuild(clips, options)
    try {
      return build.finish()
    } finally {
      build.cancel()
    }
  }

  async buildLibraryAsync(clips, options, run = {}) {
    run.signal?.throwIfAborted()
    return inSlices(this.startBuild(clips, options), run)
  }

  encodeLink(scene, options) {
    return unpack(this.#module.encodeLink(sceneTextOf(this.#module, scene), options))
  }

  decodeLink(text) {
    const { scene, search, libraryHash } = unpack(
      this.#module.decodeLink(textOf(this.#module, 'the link', text)),
    )
    return { scene: JSON.parse(scene), search, libraryHash }
  }
}

async function compile(url, bytes) {
  if (bytes) return WebAssembly.compile(bytes)
  if (url.protocol === 'file:') {
    const { readFile } = await import('node:fs/promises')
    return WebAssembly.compile(await readFile(url))
  }
  const response = await fetch(url)
  if (!response.ok) throw new Error(`${url} answered ${response.status} ${response.statusText}`)
  const isWasm = response.headers.get('Content-Type')?.startsWith('application/wasm')
  return isWasm ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer())
}

/** Loads the engine; see stridegraph.d.ts. */
export async function loadStridegraph({ wasmBinary, wasmUrl } = {}) {
  const url = new URL(wasmUrl ?? 'stridegraph_module.wasm', import.meta.url)
  const compiled = await compile(url, wasmBinary)
  let memory
  const module = await new Promise((resolve, reject) => {
    const instantiateWasm = (imports, done) => {
      WebAssembly.instantiate(compiled, imports).then((instance) => {
        memory = Object.values(instance.exports).find((value) => value instanceof WebAssembly.Memory)
        done(instance)
      }, reject)
      return {}
    }
    createStridegraphModule({ instantiateWasm }).then(resolve, reject)
  })
  return new Stridegraph(module, () => memory.buffer)
}
