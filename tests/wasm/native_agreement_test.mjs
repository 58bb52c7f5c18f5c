// The native program and the module choose the same edges on every map and in random rooms, for every library at hand.
import assert from 'node:assert/strict'
import { execFile } from 'node:child_process'
import { existsSync, readdirSync } from 'node:fs'
import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { basename, join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { edgesHash } from '../../tools/bench/edges_hash.mjs'
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

const randomRooms = 40

/** Runs the program; resolves to its exit status, 0 (done) or 1 (refused). */
async function runProgram(...words) {
  const status = await new Promise((done) => {
    execFile(program, words, (reason) => done(reason ? reason.code : 0))
  })
  assert.ok(status === 0 || status === 1, `the program ended with ${status}`)
  return status
}

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
  const status = await runProgram('plan', ...plan)
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

    it('choose the same edges in random rooms', async () => {
      const rooms = join(folder, 'rooms')
      const runs = join(folder, 'runs.json')
      const random = ['--random', '1', '--rooms', `${randomRooms}`, '--write-scenes', rooms]
      await runProgram('bench', '--graph', fileURLToPath(libraryUrl), ...random, '--json', runs)
      const natives = JSON.parse(await readFile(runs, 'utf8')).runs
      assert.equal(natives.length, randomRooms)
      for (const native of natives) {
        const scene = await readFile(join(rooms, `${native.room}.json`), 'utf8')
        const { status, report } = library.plan(scene)
        assert.equal(status, native.status, native.room)
        assert.equal(edgesHash(report.edges), native.edges, native.room)
        assert.equal(report.expansions, native.expansions, native.room)
      }
      const edges = new Set(natives.map((native) => native.edges))
      assert.ok(edges.size > randomRooms / 2, 'rooms lead to different walks')
    })
  })
}

describe('maps', () => {
  it('are there, some with a way and some without', () => {
    assert.ok(maps.length >= 7, `${mapFolder} holds ${maps.length} maps`)
  })
})
