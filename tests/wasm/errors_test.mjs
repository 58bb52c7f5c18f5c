import assert from 'node:assert/strict'
import { after, describe, it } from 'node:test'
import { defaultLibraryBytes, engine, refusalOf, smallRoom } from './support/engine.mjs'
import { newerLibrary, newerLink } from './support/newer.mjs'
import { walkerBvh, walkerClip } from './support/walker.mjs'

/** Codes that only programs can meet, since the engine opens no files. */
const notReachable = ['file']

const reached = new Set()

function refuses(code, pattern, call) {
  const refusal = refusalOf(call)
  assert.equal(refusal.code, code, refusal.message)
  assert.match(refusal.message, pattern)
  assert.ok(engine.errorCodes.includes(refusal.code))
  reached.add(refusal.code)
  return refusal
}

const build = (text, options) => () => engine.buildLibrary([{ name: 'clip.bvh', text }], options)

describe('refusals of clips', () => {
  it('blame file, line and column of a text that is no BVH', () => {
    const refusal = refuses('bvh_syntax', /HIERARCHY/, build('HIERARCHIE\nROOT hips\n'))
    assert.equal(refusal.file, 'clip.bvh')
    assert.equal(refusal.line, 1)
    assert.equal(refusal.column, 1)
  })

  it('blame a value that is no number', () => {
    const text = walkerBvh({ firstRow: `${'0 '.repeat(10)}nan${' 0'.repeat(22)}` })
    const refusal = refuses('bvh_value', /nan/i, build(text))
    assert.ok(refusal.line > 10 && refusal.column > 1)
  })

  it('name the clip whose skeleton is another', () => {
    const other = { name: 'other.bvh', text: walkerBvh({ armLength: 70 }) }
    refuses('skeleton_mismatch', /other\.bvh|cm, expected/, () => engine.buildLibrary([walkerClip(), other]))
  })

  it('say when all clips are too short', () => {
    refuses('clip_too_short', /frames/, build(walkerBvh({ frames: 5 })))
  })

  it('say when nothing connects', () => {
    refuses('empty_graph', /./, build(walkerBvh({ lean: 90 }), { threshold: 0.001 }))
  })
})

describe('refusals of libraries', () => {
  it('see damage, wherever it is', () => {
    refuses('asset_damaged', /./, () => engine.openLibrary(new Uint8Array(0)))
    refuses('asset_damaged', /./, () => engine.openLibrary(defaultLibraryBytes.subarray(0, 1000)))
    const changed = Uint8Array.from(defaultLibraryBytes)
    changed[changed.length >> 1] ^= 0x10
    refuses('asset_damaged', /./, () => engine.openLibrary(changed))
  })

  it('tell a newer file from a damaged one', () => {
    refuses('asset_version', /version/, () => engine.openLibrary(newerLibrary(defaultLibraryBytes)))
  })
})

describe('refusals of scenes', () => {
  const library = engine.openLibrary(defaultLibraryBytes)
  after(() => library.delete())

  it('blame the place in a text that is no JSON', () => {
    refuses('scene_syntax', /./, () => library.plan('{"width": 8,'))
  })

  it('name the member that is wrong', () => {
    refuses('scene_value', /width/, () => library.plan({ ...smallRoom(), width: -1 }))
    refuses('scene_value', /start/, () => library.plan({ ...smallRoom(), start: undefined }))
    refuses('scene_value', /obstacles/, () => engine.encodeLink({ ...smallRoom(), obstacles: 3 }))
  })

  it('refuse what cannot become JSON', () => {
    const circular = smallRoom()
    circular.self = circular
    refuses('invalid_argument', /JSON/, () => library.plan(circular))
    refuses('invalid_argument', /scene/, () => library.plan(undefined))
    refuses('invalid_argument', /scene/, () => engine.encodeLink(() => 0))
  })

  it('name the plan option that is wrong', () => {
    const room = smallRoom()
    refuses('invalid_argument', /seed is -1/, () => library.plan(room, { seed: -1 }))
    refuses('invalid_argument', /seed is a string/, () => library.plan(room, { seed: '1' }))
    refuses('invalid_argument', /radius is nan/i, () => library.plan(room, { radius: NaN }))
    refuses('invalid_argument', /adius/, () => library.plan(room, { radius: 50 }))
    refuses('invalid_argument', /oal/, () => library.plan(room, { goalRadius: 0 }))
    refuses('invalid_argument', /prm or rrt-connect/, () => library.plan(room, { planner: 'a-star' }))
    refuses('invalid_argument', /guided, thesis or thesis-checked/, () =>
      library.plan(room, { search: 'lucky' }),
    )
    refuses('invalid_argument', /found "goal_radius", expected one of/, () =>
      library.plan(room, { goal_radius: 1 }),
    )
    refuses('invalid_argument', /expected an object/, () => library.plan(room, 7))
  })
})

describe('refusals of arguments', () => {
  it('name what is no library, no clip, no option', () => {
    refuses('invalid_argument', /the library is a string/, () => engine.openLibrary('default.sgraph'))
    refuses('invalid_argument', /the library is null/, () => engine.openLibrary(null))
    refuses('invalid_argument', /list of clips/, () => engine.buildLibrary('HIERARCHY'))
    refuses('invalid_argument', /text of clip 1/, () => engine.buildLibrary([walkerClip(), { name: 'b' }]))
    refuses('invalid_argument', /found "treshold"/, build('', { treshold: 0.1 }))
    refuses('invalid_argument', /units is "feet"/, build('', { units: 'feet' }))
    refuses('invalid_argument', /units is 0/, build('', { units: 0 }))
    refuses('invalid_argument', /up is "x"/, build('', { up: 'x' }))
    refuses('invalid_argument', /mirror is a number/, build('', { mirror: 1 }))
    refuses('invalid_argument', /threshold/i, build(walkerBvh(), { threshold: -1 }))
    refuses('invalid_argument', /./, () => engine.buildLibrary([]))
  })

  it('name what is no hash of a library', () => {
    refuses('invalid_argument', /libraryHash/, () => engine.encodeLink(smallRoom(), { libraryHash: 'XYZ' }))
  })
})

describe('refusals of links', () => {
  it('see damage', () => {
    refuses('link_damaged', /./, () => engine.decodeLink('s=abc'))
    refuses('link_damaged', /./, () => engine.decodeLink(''))
    refuses('invalid_argument', /the link is a number/, () => engine.decodeLink(5))
  })

  it('tell a newer link from a damaged one', () => {
    refuses('link_version', /./, () => engine.decodeLink(newerLink(engine.encodeLink(smallRoom()))))
  })
})

describe('the list of codes', () => {
  it('holds nothing that was not met here, but what only programs meet', () => {
    assert.deepEqual([...engine.errorCodes].sort(), [...reached, ...notReachable].sort())
  })
})
