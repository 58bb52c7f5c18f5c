import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import * as module from '../../build/wasm/stridegraph.mjs'
import { defaultLibraryBytes, engine, root, smallRoom } from './support/engine.mjs'

const membersOf = (object) => {
  const prototype = Object.getPrototypeOf(object)
  const inherited = prototype === Object.prototype ? [] : Object.getOwnPropertyNames(prototype)
  return [...Object.keys(object), ...inherited].filter((name) => name !== 'constructor').sort()
}

describe('stridegraph.d.ts', () => {
  it('types the use of everything, and refuses misuse', () => {
    const tsc = fileURLToPath(new URL('node_modules/typescript/bin/tsc', root))
    const project = fileURLToPath(new URL('tests/wasm/tsconfig.json', root))
    assert.doesNotThrow(() =>
      execFileSync(process.execPath, [tsc, '--noEmit', '-p', project], { stdio: 'pipe' }),
    )
  })

  it('names what there is', () => {
    assert.deepEqual(Object.keys(module).sort(), ['StridegraphError', 'loadStridegraph'])
    assert.deepEqual(membersOf(engine), [
      'buildLibrary',
      'buildLibraryAsync',
      'decodeLink',
      'encodeLink',
      'errorCodes',
      'inspectClip',
      'inspectScene',
      'memory',
      'openLibrary',
      'startBuild',
    ])
    const library = engine.openLibrary(defaultLibraryBytes)
    assert.deepEqual(membersOf(library), [
      'buildReport',
      'delete',
      'info',
      'joints',
      'notes',
      'plan',
      'planAsync',
      'replan',
      'startPlan',
      'startReplan',
      'toBytes',
    ])
    const plan = library.startPlan(smallRoom())
    assert.deepEqual(membersOf(plan), ['cancel', 'finish', 'progress', 'step', 'walk'])
    plan.cancel()
    assert.deepEqual(membersOf(library.plan(smallRoom())), [
      'allToGlb',
      'blended',
      'contacts',
      'fps',
      'frames',
      'joints',
      'kept',
      'others',
      'path',
      'positions',
      'report',
      'roadmap',
      'rotations',
      'status',
      'subgoals',
      'toBvh',
      'toGlb',
    ])
    library.delete()
  })
})
