import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { defaultLibraryBytes, engine, refusalOf, smallRoom } from './support/engine.mjs'
import { walkerBvh, walkerClip } from './support/walker.mjs'

describe('openLibrary', () => {
  it('opens the default library and says what it holds', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    const { info, joints } = library
    assert.match(info.hash, /^[0-9a-f]{16}$/)
    assert.ok(info.nodes > 10 && info.clipPieces > 10 && info.transitions > 10)
    assert.equal(
      info.clips.reduce((sum, clip) => sum + clip.frames, 0),
      info.frames,
    )
    assert.equal(joints[0].parent, -1)
    joints.slice(1).forEach((joint, index) => assert.ok(joint.parent <= index, joint.name))
    assert.ok(info.contactJoints.every((joint) => joint < joints.length))
    library.delete()
  })

  it('takes an ArrayBuffer and a view into a larger one', () => {
    const padded = new Uint8Array(defaultLibraryBytes.length + 7)
    padded.set(defaultLibraryBytes, 7)
    const fromView = engine.openLibrary(padded.subarray(7))
    const fromBuffer = engine.openLibrary(padded.slice(7).buffer)
    assert.equal(fromView.info.hash, fromBuffer.info.hash)
    fromView.delete()
    fromBuffer.delete()
  })

  it('gives back the bytes that it was opened from', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    assert.deepEqual(Buffer.from(library.toBytes()), Buffer.from(defaultLibraryBytes))
    library.delete()
  })

  it('refuses all use after delete, which may be called twice', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    library.delete()
    library.delete()
    for (const call of [() => library.plan(smallRoom()), () => library.toBytes()]) {
      const refusal = refusalOf(call)
      assert.equal(refusal.code, 'invalid_argument')
      assert.match(refusal.message, /deleted/)
    }
  })

  it('hands out figures that are the caller’s to change', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    library.info.clips.length = 0
    library.joints.length = 0
    assert.ok(library.info.clips.length > 0 && library.joints.length > 0)
    library.delete()
  })
})

describe('buildLibrary', () => {
  it('builds what opens again as the same library', () => {
    const built = engine.buildLibrary([walkerClip()], { license: 'made for a test' })
    const opened = engine.openLibrary(built.toBytes())
    assert.equal(opened.info.hash, built.info.hash)
    assert.equal(opened.info.license, 'made for a test')
    assert.equal(opened.buildReport, undefined)
    built.delete()
    opened.delete()
  })

  it('reports what became of every clip', () => {
    const library = engine.buildLibrary([walkerClip()])
    const { buildReport } = library
    assert.equal(buildReport.clips.length, 1)
    assert.equal(buildReport.clips[0].name, 'walker.bvh')
    assert.equal(buildReport.clips[0].frames, 90)
    assert.equal(buildReport.nodes, library.info.nodes)
    assert.equal(buildReport.transitions, library.info.transitions)
    assert.equal(buildReport.transitionsBeforeThinning, buildReport.transitions)
    assert.ok(buildReport.survivingShare > 0 && buildReport.survivingShare <= 1)
    assert.ok(Array.isArray(buildReport.warnings))
    library.delete()
  })

  it('obeys the options', () => {
    const library = engine.buildLibrary([walkerClip()], {
      fps: 60,
      threshold: 0.04,
      transitionFrames: 9,
      units: 0.01,
    })
    assert.equal(library.info.fps, 60)
    assert.equal(library.info.thresholdMetres, 0.04)
    assert.equal(library.info.transitionFrames, 9)
    assert.equal(library.info.frames, 179)
    library.delete()
    for (const option of [{ neighbours: 101 }, { spanRatio: 2.5 }, { mostTransitions: 999 }]) {
      assert.equal(refusalOf(() => engine.buildLibrary([walkerClip()], option)).code, 'invalid_argument')
    }
  })

  it('counts the pairs of frames that it has compared so far', () => {
    const build = engine.startBuild([walkerClip(), { name: 'more', text: walkerBvh({ frames: 60 }) }])
    assert.equal(build.framePairs, 0)
    let pairs = 0
    while (build.step()) {
      assert.ok(build.framePairs >= pairs)
      pairs = build.framePairs
    }
    const library = build.finish()
    assert.ok(pairs > 0)
    assert.equal(pairs, library.buildReport.framePairs)
    library.delete()
  })

  it('appends to the same bytes as building at once', () => {
    const more = { name: 'more', text: walkerBvh({ frames: 60 }) }
    const atOnce = engine.buildLibrary([walkerClip(), more], { license: 'made for a test' })
    const first = engine.buildLibrary([walkerClip()], { license: 'made for a test' })
    const grown = engine.buildLibrary([more], { append: first.toBytes() })
    assert.deepEqual(grown.toBytes(), atOnce.toBytes())
    assert.ok(grown.buildReport.framePairs < atOnce.buildReport.framePairs)
    for (const library of [atOnce, first, grown]) library.delete()
  })

  it('refuses settings beside a library to append to, and what is no library', () => {
    const append = defaultLibraryBytes
    const { message } = refusalOf(() => engine.buildLibrary([walkerClip()], { append, mirror: true }))
    assert.equal(
      message,
      'build options: found mirror beside append, expected none: the library keeps its own',
    )
    assert.equal(
      refusalOf(() => engine.buildLibrary([walkerClip()], { append: new Uint8Array(9) })).code,
      'asset_damaged',
    )
    assert.equal(
      refusalOf(() => engine.buildLibrary([walkerClip()], { append: 'walk.sgraph' })).code,
      'invalid_argument',
    )
    assert.equal(refusalOf(() => engine.buildLibrary([walkerClip()], { append })).code, 'skeleton_mismatch')
  })

  it('leaves no memory behind when clips are refused', () => {
    const attempt = () =>
      refusalOf(() =>
        engine.buildLibrary([walkerClip(), { name: 'b', text: walkerBvh({ frames: 3 }).slice(0, 60) }]),
      )
    attempt()
    const before = engine.memory.usedBytes
    attempt()
    assert.equal(engine.memory.usedBytes, before)
  })
})

describe('startBuild', () => {
  it('makes the same library step by step, with progress that only grows', () => {
    const atOnce = engine.buildLibrary([walkerClip()])
    const build = engine.startBuild([walkerClip()])
    const progress = [build.progress]
    while (build.step()) progress.push(build.progress)
    const library = build.finish()
    assert.equal(library.info.hash, atOnce.info.hash)
    assert.ok(progress.length > 2)
    assert.ok(
      progress.every(
        (value, index) => value >= 0 && value <= 1 && (index === 0 || value >= progress[index - 1]),
      ),
    )
    library.delete()
    atOnce.delete()
  })

  it('gives its memory back when cancelled', () => {
    const begin = () => {
      const build = engine.startBuild([walkerClip()])
      build.step()
      build.step()
      build.cancel()
      assert.equal(refusalOf(() => build.step()).code, 'invalid_argument')
    }
    begin()
    const before = engine.memory.usedBytes
    begin()
    assert.equal(engine.memory.usedBytes, before)
  })
})

describe('buildLibraryAsync', () => {
  it('tells its progress and keeps the event loop alive', async () => {
    let turns = 0
    const timer = setInterval(() => ++turns, 0)
    const seen = []
    const library = await engine.buildLibraryAsync(
      [walkerClip()],
      {},
      { onProgress: (p) => seen.push(p), sliceMs: 0 },
    )
    clearInterval(timer)
    assert.ok(seen.length > 1 && turns > 0)
    assert.equal(seen.at(-1), 1)
    library.delete()
  })

  it('stops when its signal says so', async () => {
    const stop = new AbortController()
    const onProgress = () => stop.abort()
    const run = engine.buildLibraryAsync([walkerClip()], {}, { onProgress, signal: stop.signal, sliceMs: 0 })
    await assert.rejects(run, { name: 'AbortError' })
    await assert.rejects(engine.buildLibraryAsync([walkerClip()], {}, { signal: stop.signal }), {
      name: 'AbortError',
    })
  })
})
