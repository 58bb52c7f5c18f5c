// Every file that leaves the module is judged by those who wrote the standard, and measured by its own numbers.
import assert from 'node:assert/strict'
import { readdir, readFile } from 'node:fs/promises'
import { after, before, describe, it } from 'node:test'
import validator from 'gltf-validator'
import { defaultLibraryBytes, engine, root } from './support/engine.mjs'
import { floatsOf, jsonOf, lowestVertices } from './support/glb.mjs'
import { walkerBvh } from './support/walker.mjs'

let library
before(() => {
  library = engine.openLibrary(defaultLibraryBytes)
})
after(() => library.delete())

const scenes = new URL('public/scenes/', root)
const readScene = async (url) => JSON.parse(await readFile(url, 'utf8'))

/** No error, warning, information or hint. */
async function assertFlawless(glb, name) {
  const { issues } = await validator.validateBytes(glb)
  const { numErrors, numWarnings, numInfos, numHints } = issues
  assert.equal(
    numErrors + numWarnings + numInfos + numHints,
    0,
    `${name}: ${JSON.stringify(issues.messages.slice(0, 5))}`,
  )
}

function assertNamesDiffer(glb, name) {
  const json = jsonOf(glb)
  for (const kind of ['nodes', 'meshes', 'skins', 'materials', 'animations']) {
    const names = (json[kind] ?? []).map((object) => object.name)
    assert.equal(new Set(names).size, names.length, `${name}: names of ${kind}: ${names}`)
    // eslint-disable-next-line no-control-regex
    names.forEach((each) => assert.doesNotMatch(each, /[\u0000-\u001f\u007f-\u009f]|^$/u))
  }
}

function assertTimesGrow(times, name) {
  assert.equal(times[0], 0)
  for (let f = 1; f < times.length; ++f) assert.ok(times[f] > times[f - 1], `${name}: time of key ${f}`)
}

function assertSignsStay(keys, stride, name) {
  for (let i = stride; i + 3 < keys.length; i += 4) {
    let dot = 0
    for (let k = 0; k < 4; ++k) dot += keys[i + k] * keys[i - stride + k]
    assert.ok(dot >= 0, `${name}: sign turns at number ${i}`)
  }
}

async function assertSound(glb, name) {
  await assertFlawless(glb, name)
  assertNamesDiffer(glb, name)
  for (const { channels, samplers } of jsonOf(glb).animations ?? []) {
    for (const { sampler, target } of channels) {
      assertTimesGrow(floatsOf(glb, samplers[sampler].input), name)
      if (target.path === 'rotation') assertSignsStay(floatsOf(glb, samplers[sampler].output), 4, name)
    }
  }
}

describe('exports of every sample scene', async () => {
  const files = (await readdir(scenes)).filter((file) => file.endsWith('.json'))
  for (const file of files) {
    it(`are sound: ${file}`, async () => {
      const walk = library.plan(await readScene(new URL(file, scenes)))
      for (const each of [walk, ...walk.others].filter(({ frames }) => frames > 0)) {
        assertSignsStay(each.rotations, 4 * each.joints.length, file)
        await assertSound(each.toGlb(), file)
      }
      if (walk.frames > 0) await assertSound(walk.allToGlb(), file)
    })
  }
})

describe('a way that turns past half a turn', () => {
  it('keeps the signs of rotations, in the file and in the arrays', async () => {
    const scene = await readScene(new URL('tests/data/cases/slalom.json', root))
    for (const seed of [1, 2, 3, 4, 5]) {
      const walk = library.plan(scene, { seed })
      assert.equal(walk.status, 'arrived')
      assertSignsStay(walk.rotations, 4 * walk.joints.length, `seed ${seed}`)
      await assertSound(walk.toGlb(), `seed ${seed}`)
    }
  })
})

describe('the exported body', () => {
  it('stands and walks on the floor, with a head on its shoulders', async () => {
    const walk = library.plan(await readScene(new URL('one_obstacle.json', scenes)))
    const { lowest, highest } = lowestVertices(walk.toGlb())
    assert.ok(Math.abs(lowest[0]) < 0.002, `lowest vertex at ${lowest[0]} m while standing`)
    assert.ok(highest[0] > 1.6 && highest[0] < 1.9, `highest vertex at ${highest[0]} m`)
    lowest.forEach((y, f) => assert.ok(y > -0.005 && y < 0.015, `lowest vertex of frame ${f} at ${y} m`))
    const planted = lowest.filter((y) => Math.abs(y) < 0.002).length
    assert.ok(planted > 0.95 * lowest.length, `${planted} of ${lowest.length} frames touch the floor`)
  })

  it('wears the colour of its walker, alone and with others', async () => {
    const walk = library.plan(await readScene(new URL('crossing.json', scenes)))
    const colourOf = (glb, i) => jsonOf(glb).materials[i].pbrMetallicRoughness.baseColorFactor
    const all = walk.allToGlb()
    assert.ok(walk.others.length > 0)
    ;[walk, ...walk.others].forEach((each, i) =>
      assert.deepEqual(colourOf(all, i), colourOf(each.toGlb(), 0)),
    )
    assert.notDeepEqual(colourOf(all, 0), colourOf(all, 1))
  })
})

describe('exports of a body of one’s own', () => {
  const rename = {
    'in other scripts': (text) =>
      text.replace('Hips', 'Таз').replace('Spine', '脊椎').replace('LeftLeg', 'عظم'),
    'with joints of one name': (text) => text.replaceAll(/JOINT \w+/g, 'JOINT joint'),
    'with names that the file uses itself': (text) =>
      text.replace('Spine', 'body').replace('Head', 'walker_1'),
  }
  for (const [name, change] of Object.entries(rename)) {
    it(`are sound ${name}`, async () => {
      const own = engine.buildLibrary([{ name: 'walk.bvh', text: change(walkerBvh()) }])
      const start = { x: 2, z: 2 }
      const walkers = [{ start: { x: 2, z: 6 }, goal: { x: 5, z: 6 } }]
      const walk = own.plan(
        { version: 1, width: 8, depth: 8, obstacles: [], start, goal: { x: 5, z: 2 }, walkers },
        { goalRadius: 1, standing: false },
      )
      assert.equal(walk.status, 'arrived', walk.report.explanation)
      await assertSound(walk.toGlb(), name)
      await assertSound(walk.allToGlb(), name)
      own.delete()
    })
  }
})
