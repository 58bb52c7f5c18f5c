import assert from 'node:assert/strict'
import { after, before, describe, it } from 'node:test'
import validator from 'gltf-validator'
import { defaultLibraryBytes, engine, refusalOf, smallRoom } from './support/engine.mjs'

let library
before(() => {
  library = engine.openLibrary(defaultLibraryBytes)
})
after(() => library.delete())

describe('toBvh', () => {
  it('writes every frame with the channels of the clips', () => {
    const walk = library.plan(smallRoom())
    const lines = walk.toBvh().split(/\r?\n/)
    const channels = lines
      .map((line) => Number(/CHANNELS (\d+)/.exec(line)?.[1] ?? 0))
      .reduce((a, b) => a + b)
    const motion = lines.findIndex((line) => /^Frame Time:/.test(line)) + 1
    const rows = lines.slice(motion).filter((line) => line.trim() !== '')
    assert.equal(rows.length, walk.frames)
    rows.forEach((row) => assert.equal(row.trim().split(/\s+/).length, channels))
  })

  it('writes what reads back as the same motion', () => {
    const walk = library.plan(smallRoom())
    const name = 'walk.bvh'
    const build = engine.startBuild([{ name, text: walk.toBvh() }], { fps: walk.fps })
    assert.equal(build.step(), true)
    build.cancel()
  })
})

describe('toGlb', () => {
  it('passes the validator of the standard', async () => {
    const glb = library.plan(smallRoom()).toGlb()
    const { issues, info } = await validator.validateBytes(glb)
    assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages.slice(0, 5)))
    assert.equal(issues.numWarnings, 0, JSON.stringify(issues.messages.slice(0, 5)))
    assert.equal(info.animationCount, 1)
  })
})

describe('allToGlb', () => {
  const walkers = [
    { start: { x: 1, z: 1.5 }, goal: { x: 7, z: 1.5 } },
    { start: { x: 1, z: 4.5 }, goal: { x: 7, z: 4.5 } },
  ]

  it('holds every walker who arrives, and passes the validator of the standard', async () => {
    const walk = library.plan({ ...smallRoom(), walkers })
    assert.deepEqual(
      [walk, ...walk.others].map(({ status }) => status),
      Array(3).fill('arrived'),
    )
    const glb = walk.allToGlb()
    const { issues, info } = await validator.validateBytes(glb)
    assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages.slice(0, 5)))
    assert.equal(info.animationCount, 1)
    const length = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true)
    const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + length)))
    const names = json.scenes[0].nodes.map((node) => json.nodes[node].name)
    assert.deepEqual(
      names.filter((name) => !name.endsWith('body')),
      ['walker_1', 'walker_2', 'walker_3'],
    )
    assert.equal(json.skins.length, 3)
  })

  it('is toGlb for one, leaves out who does not arrive, and refuses where nobody does', () => {
    const alone = library.plan(smallRoom())
    assert.deepEqual(alone.allToGlb(), alone.toGlb())
    const blocked = library.plan({ ...smallRoom(), goal: { x: 4, z: 4 }, walkers: walkers.slice(0, 1) })
    assert.equal(blocked.status, 'goal_blocked')
    assert.deepEqual(blocked.allToGlb(), blocked.others[0].toGlb())
    const nobody = library.plan({ ...smallRoom(), goal: { x: 4, z: 4 } })
    assert.match(refusalOf(() => nobody.allToGlb()).message, /goal_blocked/)
  })
})

describe('export', () => {
  it('refuses a plan that did not arrive', () => {
    const walk = library.plan({ ...smallRoom(), goal: { x: 4, z: 4 } })
    for (const call of [() => walk.toBvh(), () => walk.toGlb()]) {
      const refusal = refusalOf(call)
      assert.equal(refusal.code, 'invalid_argument')
      assert.match(refusal.message, /goal_blocked/)
    }
  })
})
