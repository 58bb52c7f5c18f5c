import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { engine, refusalOf, smallRoom } from './support/engine.mjs'

describe('links', () => {
  it('hold scene, search and library', () => {
    const scene = {
      ...smallRoom(),
      name: 'Küche “2”',
      seed: 42,
      radius: 0.35,
      walkers: [{ start: { x: 1, z: 1 }, goal: { x: 2, z: 2.5, heading_deg: 45 } }],
      constraints: { gait: 'run', areas: [{ x: 3, z: 3, width: 1, depth: 2, kind: 'prefer' }] },
    }
    const link = engine.encodeLink(scene, { search: 'thesis', libraryHash: '0123456789abcdef' })
    const { scene: back, search, libraryHash } = engine.decodeLink(link)
    assert.equal(search, 'thesis')
    assert.equal(libraryHash, '0123456789abcdef')
    for (const member of Object.keys(scene)) assert.deepEqual(back[member], scene[member], member)
  })

  it('are text that may stand in an address as it is, with or without #', () => {
    const link = engine.encodeLink(smallRoom())
    assert.match(link, /^s=[A-Za-z0-9_.~-]+$/)
    assert.deepEqual(engine.decodeLink(`#${link}`), engine.decodeLink(link))
    assert.equal(engine.decodeLink(link).libraryHash, null)
  })

  it('are the same for the same scene', () => {
    assert.equal(engine.encodeLink(smallRoom()), engine.encodeLink(JSON.stringify(smallRoom())))
  })

  it('are refused with a sentence wherever a letter was changed', () => {
    const link = engine.encodeLink(smallRoom())
    for (let at = 2; at < link.length; ++at) {
      const changed = link.slice(0, at) + (link[at] === 'A' ? 'B' : 'A') + link.slice(at + 1)
      const { code, message } = refusalOf(() => engine.decodeLink(changed))
      assert.match(code, /^link_(damaged|version)$/)
      assert.ok(message.length > 10)
    }
  })
})
