import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { defaultLibraryBytes, engine, refusalOf, smallRoom } from './support/engine.mjs'

/** What the allocator takes at least: who leaks once each time leaks this much each time. */
const smallestAllocation = 16

/** Runs `work` with a library of its own, so many times, and checks that it leaves nothing behind. */
function checkFlat(times, work) {
  const run = (count) => {
    const library = engine.openLibrary(defaultLibraryBytes)
    work(library)
    const { usedBytes } = engine.memory
    for (let i = 0; i < count; ++i) work(library)
    // What the library keeps, the last walk, may lie in chunks that are some bytes larger than another time.
    assert.ok(engine.memory.usedBytes - usedBytes < count * smallestAllocation)
    library.delete()
  }
  run(times)
  const before = engine.memory
  run(times)
  assert.deepEqual(engine.memory, before)
}

describe('the heap', () => {
  it('is flat after 1,000 plans', () => {
    let seed = 0
    checkFlat(1000, (library) => library.plan(smallRoom(), { seed: (seed = (seed + 1) % 2) }))
  })

  it('is flat after plans that fail, refusals, links and exports', () => {
    checkFlat(20, (library) => {
      const walk = library.plan(smallRoom())
      library.plan({ ...smallRoom(), goal: { x: 4, z: 4 } })
      refusalOf(() => library.plan('{'))
      refusalOf(() => library.plan(smallRoom(), { planner: 'x' }))
      engine.decodeLink(engine.encodeLink(smallRoom()))
      walk.toBvh()
      walk.toGlb()
      walk.allToGlb()
      library.toBytes()
    })
  })

  it('is flat after plans that are improved, finished or given up', () => {
    checkFlat(20, (library) => {
      library.startPlan(smallRoom(), { improve: 3000 }).finish()
      const plan = library.startPlan(smallRoom(), { improve: 3000 })
      plan.step()
      plan.cancel()
    })
  })

  it('is flat when libraries come and go', () => {
    const comeAndGo = () => engine.openLibrary(defaultLibraryBytes).delete()
    comeAndGo()
    const before = engine.memory
    for (let i = 0; i < 10; ++i) comeAndGo()
    assert.deepEqual(engine.memory, before)
  })
})
