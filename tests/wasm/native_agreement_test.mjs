// The native program and the module choose the same edges on every map, for every library at hand.
import assert from 'node:assert/strict'
import { execFile } from 'node:child_process'
import { existsSync, readdirSync } from 'node:fs'
import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { engine, root } from './support/engine.mjs'

const program = fileURLToPath(new URL('build/bin/stridegraph', root))
const mapFolder = process.env.STRIDEGRAPH_MAPS || fileURLToPath(new URL('public/scenes', root))
const isMap = (name) => name.endsWith('.json') && name !== 'index.json'
const maps = readdirSync(mapFolder).filter(isMap).sort()
const captures = ['cmu16_walk', 'accad_male1_walk'].map(
  (name) => new URL(`build/captures/${name}.sgraph`, root),
)
const libraries = [new URL('build/library/default.sgraph', root), ...captures].filter((url) =>
  existsSync(url),
)
const seeds = [1, 2]

/** The program's report of a plan; it exits with 1 when there is no way, and still writes one. */
async function nativeReport(folder, library, map, seed) {
  const report = join(folder, 'report.json')
  const walk = join(folder, 'walk.bvh')
  const plan = [
    '--graph',
    fileURLToPath(library),
    '--scene',
    map,
    '-o',
    walk,
    '--seed',
    `${seed}`,
    '--report',
    report,
  ]
  const status = await new Promise((done) => {
    execFile(program, ['plan', ...plan], (reason) => done(reason ? reason.code : 0))
  })
  assert.ok(status === 0 || status === 1, `the program ended with ${status}`)
  return {
    report: JSON.parse(await readFile(report, 'utf8')),
    bvh: status === 0 ? await readFile(walk, 'utf8') : '',
  }
}

for (const libraryUrl of libraries) {
  describe(`native program and module with ${basename(libraryUrl.pathname)}`, () => {
    let folder
    let library
    before(async () => {
      folder = await mkdtemp(join(tmpdir(), 'stridegraph-'))
      library = engine.openLibrary(await readFile(libraryUrl))
    })
    after(async () => {
      library.delete()
      await rm(folder, { recursive: true })
    })

    for (const map of maps) {
      it(`choose the same edges on ${map}`, async () => {
        const scene = await readFile(join(mapFolder, map), 'utf8')
        for (const seed of seeds) {
          const native = await nativeReport(folder, libraryUrl, join(mapFolder, map), seed)
          const walk = library.plan(scene, { seed })
          assert.equal(walk.status, native.report.status)
          assert.deepEqual(walk.report.edges, native.report.edges)
          assert.equal(walk.report.expansions, native.report.expansions)
          assert.equal(walk.frames, native.report.frames)
        }
      })
    }
  })
}

describe('maps', () => {
  it('are there, some with a way and some without', () => {
    assert.ok(maps.length >= 7, `${mapFolder} holds ${maps.length} maps`)
  })
})
