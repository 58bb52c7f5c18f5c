import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { describe, it } from 'node:test'
import validator from 'gltf-validator'
import { engine, refusalOf, root, smallRoom } from './support/engine.mjs'
import { walkerBvh, walkerClip } from './support/walker.mjs'

const encoder = new TextEncoder()
const caseBytes = (name) => readFile(new URL(`tests/data/cases/${name}`, root))

/** What a library holds but for the names of its joints and clips. */
function hashOf(clip, options) {
  const library = engine.buildLibrary([clip], options)
  const { hash } = library.info
  library.delete()
  return hash
}

describe('clips', () => {
  it('are the same as text, as bytes, and as a view into a larger buffer', () => {
    const { name, text } = walkerClip()
    const bytes = encoder.encode(text)
    const padded = new Uint8Array(bytes.length + 5)
    padded.set(bytes, 5)
    const hash = hashOf({ name, text })
    assert.equal(hashOf({ name, bytes }), hash)
    assert.equal(hashOf({ name, bytes: bytes.buffer }), hash)
    assert.equal(hashOf({ name, bytes: padded.subarray(5) }), hash)
    assert.equal(hashOf({ name, bytes: new DataView(padded.buffer, 5) }), hash)
  })

  it('are copied at once', () => {
    const { name, text } = walkerClip()
    const bytes = encoder.encode(text)
    const build = engine.startBuild([{ name, bytes }])
    bytes.fill(0)
    const library = build.finish()
    assert.equal(library.info.hash, hashOf({ name, text }))
    library.delete()
  })

  it('go by their own unit and up axis before those of the build', () => {
    const clip = walkerClip()
    const inches = hashOf(clip, { units: 'in' })
    assert.notEqual(inches, hashOf(clip))
    assert.equal(hashOf({ ...clip, units: 'in' }), inches)
    assert.equal(hashOf({ ...clip, units: 'in' }, { units: 'm', up: 'auto' }), inches)
    assert.equal(hashOf({ ...clip, units: 'auto' }, { units: 'in' }), inches)
  })

  const refused = (clip, pattern) => {
    for (const call of [() => engine.buildLibrary([clip]), () => engine.inspectClip(clip)]) {
      const refusal = refusalOf(call)
      assert.equal(refusal.code, 'invalid_argument')
      assert.match(refusal.message, pattern)
    }
  }

  it('are refused when they are neither text nor bytes, or both', () => {
    const { name, text } = walkerClip()
    refused({ name }, /text of .*clip.* is undefined, expected a string/)
    refused({ name, bytes: text }, /bytes of .*clip.* is a string, expected an ArrayBuffer/)
    refused({ name, text, bytes: encoder.encode(text) }, /both text and bytes/)
    refused(text, /clip.* is a string, expected an object/)
    refused({ text }, /name of .*clip/)
  })

  it('are refused with readings that are none', () => {
    const clip = walkerClip()
    refused({ ...clip, units: 'feet' }, /clip options: units is "feet", expected auto, m, cm, in/)
    refused({ ...clip, units: 0 }, /units is 0, expected metres per unit above 0/)
    refused({ ...clip, up: 'x' }, /clip options: up is "x", expected auto, y or z/)
    refused({ ...clip, unit: 'cm' }, /found "unit", expected one of units, up/)
  })

  it('are refused when their bytes were handed on', () => {
    const bytes = encoder.encode(walkerBvh()).buffer
    structuredClone(bytes, { transfer: [bytes] })
    refused({ name: 'gone.bvh', bytes }, /bytes of .* is a buffer that was handed on/)
  })
})

describe('inspectClip', () => {
  it('tells what a clip holds and how it was understood', () => {
    const clip = engine.inspectClip(walkerClip())
    assert.equal(clip.name, 'walker.bvh')
    assert.equal(clip.frames, 90)
    assert.ok(Math.abs(clip.fps - 30) < 0.01 && Math.abs(clip.seconds - 3) < 0.01)
    assert.equal(clip.joints[0].name, 'Hips')
    assert.deepEqual([clip.unitsPerMetre, clip.up], [100, 'y'])
    assert.ok(clip.heightMetres > 1.4 && clip.heightMetres < 1.9, `${clip.heightMetres}`)
    assert.ok(clip.unitConfidence > 0 && clip.unitConfidence <= 1)
    assert.ok(Array.isArray(clip.warnings))
  })

  it('has no doubt about what it was told', () => {
    const clip = engine.inspectClip(walkerClip(), { units: 'm', up: 'z' })
    assert.deepEqual([clip.unitsPerMetre, clip.up, clip.doubts], [1, 'z', []])
    assert.deepEqual([clip.unitConfidence, clip.upConfidence], [1, 1])
    const own = engine.inspectClip({ ...walkerClip(), up: 'y' }, { units: 'm', up: 'z' })
    assert.deepEqual([own.unitsPerMetre, own.up], [1, 'y'])
  })

  it('names the doubts that it measures', () => {
    const { doubts, unitConfidence, upConfidence } = engine.inspectClip(walkerClip())
    assert.equal(doubts.includes('unit'), unitConfidence < 0.8)
    assert.equal(doubts.includes('up_axis'), upConfidence < 0.8)
  })

  it('refuses what a build refuses, with the same place', () => {
    const text = 'HIERARCHY\nROOT hips\n'
    const inspected = refusalOf(() => engine.inspectClip({ name: 'a.bvh', text }))
    const built = refusalOf(() => engine.buildLibrary([{ name: 'a.bvh', text }]))
    assert.deepEqual({ ...inspected }, { ...built })
    assert.equal(inspected.message, built.message)
    assert.equal(refusalOf(() => engine.inspectClip(walkerClip(), { fps: 30 })).code, 'invalid_argument')
  })
})

describe('texts with lone surrogates', () => {
  const lone = 'a\ud800b\udc00'
  const whole = 'a\ufffdb\ufffd'

  it('become U+FFFD in names, texts and options', () => {
    const text = walkerBvh().replace('ROOT Hips', `ROOT H\ud83dps`)
    const library = engine.buildLibrary([{ name: lone, text }], { license: lone })
    assert.equal(library.info.clips[0].name, whole)
    assert.equal(library.info.license, whole)
    assert.equal(library.joints[0].name, 'H\ufffdps')
    library.delete()
  })

  it('become U+FFFD in scenes, whether objects or texts', () => {
    for (const scene of [
      { ...smallRoom(), name: lone },
      JSON.stringify(smallRoom()).replace('{', `{"name":"${lone}",`),
    ]) {
      assert.equal(engine.decodeLink(engine.encodeLink(scene)).scene.name, whole)
    }
    const escaped = { ...smallRoom(), name: '\\ud800 \u{1F6B6} \u0001', [lone]: 1 }
    const { scene } = engine.decodeLink(engine.encodeLink(escaped))
    assert.equal(scene.name, escaped.name)
    assert.equal(scene[whole], 1)
  })

  it('are refused like any others where names are chosen from a list', () => {
    assert.equal(
      refusalOf(() => engine.encodeLink(smallRoom(), { libraryHash: lone })).code,
      'invalid_argument',
    )
    assert.equal(refusalOf(() => engine.decodeLink(lone)).code, 'link_damaged')
  })
})

describe('files in other encodings', () => {
  it('give walks that are valid wherever they are written', async () => {
    const clip = { name: 'latin1_names.bvh', bytes: await caseBytes('latin1_names.bvh') }
    const library = engine.buildLibrary([clip])
    assert.equal(library.joints[0].name, 'Hüfte')
    assert.ok(library.notes.some(({ topic, file }) => topic === 'text' && file === clip.name))
    const scene = { ...smallRoom(), width: 12, obstacles: [], goal: { x: 10, z: 4 } }
    const walk = library.plan(scene)
    assert.equal(walk.status, 'arrived')
    assert.match(walk.toBvh(), /ROOT Hüfte/)
    const { issues } = await validator.validateBytes(walk.toGlb())
    assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages.slice(0, 5)))
    library.delete()
  })

  it('are read alike in UTF-8 and UTF-16', async () => {
    const joints = async (name) => engine.inspectClip({ name, bytes: await caseBytes(name) }).joints
    assert.deepEqual(await joints('utf16.bvh'), await joints('straight.bvh'))
  })
})

describe('inspectScene', () => {
  it('names members that have no effect', async () => {
    const { warnings } = engine.inspectScene((await caseBytes('misspelt_members.json')).toString())
    assert.ok(warnings.every(({ topic }) => topic === 'scene'))
    for (const member of ['start.heading', 'constraint']) {
      assert.ok(
        warnings.some(({ message }) => message.includes(`${member},`)),
        member,
      )
    }
    assert.deepEqual(engine.inspectScene(smallRoom()).warnings, [])
  })

  it('refuses what is no scene', () => {
    assert.equal(refusalOf(() => engine.inspectScene('{')).code, 'scene_syntax')
    assert.equal(refusalOf(() => engine.inspectScene({})).code, 'scene_value')
  })
})

describe('notes of a library', () => {
  it('are what was odd about its files, and stay with it', async () => {
    const name = 'one_frame_more.bvh'
    const library = engine.buildLibrary([{ name, bytes: await caseBytes(name) }])
    const { notes } = library
    assert.deepEqual(notes, library.buildReport.warnings)
    assert.ok(notes.some(({ topic, file, line }) => topic === 'rows' && file === name && line > 0))
    notes.length = 0
    assert.ok(library.notes.length > 0)
    const opened = engine.openLibrary(library.toBytes())
    assert.deepEqual(opened.notes, library.notes)
    library.delete()
    opened.delete()
  })
})
