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
