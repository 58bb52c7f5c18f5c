import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { defaultLibraryBytes, engine, refusalOf, smallRoom } from './support/engine.mjs'

/** Runs `work` once to fill caches, then `times` more, and says how the heap grew: [in use, size], bytes. */
function growth(times, work) {
  work()
  const before = engine.memory
  for (let i = 0; i < times; ++i) work()
  const after = engine.memory
  return [after.usedBytes - before.usedBytes, after.heapBytes - before.heapBytes]
}

describe('the heap', () => {
  it('is flat after 1,000 plans', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    let seed = 0
    assert.deepEqual(
      growth(1000, () => library.plan(smallRoom(), { seed: (seed = (seed + 1) % 2) })),
      [0, 0],
    )
    library.delete()
  })

  it('is flat after plans that fail, refusals, links and exports', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    const walk = library.plan(smallRoom())
    const work = () => {
      library.plan({ ...smallRoom(), goal: { x: 4, z: 4 } })
      refusalOf(() => library.plan('{'))
      refusalOf(() => library.plan(smallRoom(), { planner: 'x' }))
      engine.decodeLink(engine.encodeLink(smallRoom()))
      walk.toBvh()
      walk.toGlb()
      walk.allToGlb()
      library.toBytes()
    }
    assert.deepEqual(growth(20, work), [0, 0])
    library.delete()
  })

  it('is flat after plans that are improved, finished or given up', () => {
    const library = engine.openLibrary(defaultLibraryBytes)
    const work = () => {
      library.startPlan(smallRoom(), { improve: 3000 }).finish()
      const plan = library.startPlan(smallRoom(), { improve: 3000 })
      plan.step()
      plan.cancel()
    }
    assert.deepEqual(growth(20, work), [0, 0])
    library.delete()
  })

  it('is flat when libraries come and go', () => {
    const work = () => engine.openLibrary(defaultLibraryBytes).delete()
    assert.deepEqual(growth(10, work), [0, 0])
  })
})
