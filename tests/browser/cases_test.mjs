// Small inputs that stand for kinds of faults (tests/data/cases), each dropped on the page: its right result.
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { after, afterEach, before, describe, it } from 'node:test'
import { Visit, startBrowser } from './page_driver.mjs'

const folder = new URL('../data/cases/', import.meta.url)
const caseFile = async (name) => ({ name, bytes: await readFile(new URL(name, folder)) })

/** A scene that every clip of the cases can walk: straight on, from standing anywhere. */
const straightOn = {
  name: 'straight_on.json',
  bytes: Buffer.from(
    JSON.stringify({
      version: 1,
      name: 'straight on',
      width: 12,
      depth: 6,
      obstacles: [],
      start: { x: 2, z: 3, heading_deg: 90 },
      goal: { x: 9, z: 3 },
      seed: 1,
    }),
  ),
}

let server
let visit
before(async () => {
  server = await startBrowser()
  visit = await Visit.start(server)
  await visit.untilPlanned()
})
// What a failed test leaves open is not the next one's.
afterEach(() =>
  visit.page.evaluate(() => document.querySelectorAll('dialog.report').forEach((dialog) => dialog.close())),
)
after(async () => {
  await visit?.end()
  await server?.stop()
})

/** Drops a clip; resolves with {problem}, or with {state, notes} once its library is open and a walk is planned. */
async function dropClip(name) {
  const { library_hash: hashBefore } = await visit.state()
  await visit.drop([await caseFile(name)])
  await visit.page.waitForFunction(
    (hash) =>
      document.querySelector('dialog.report[open]') !== null ||
      globalThis.stridegraphApp.state().library_hash !== hash,
    hashBefore,
    { timeout: 60_000 },
  )
  if ((await visit.page.locator('#problem-dialog').count()) > 0) {
    const problem = await visit.dialogText('problem-dialog')
    await visit.answer('problem-dialog', 'Close')
    assert.equal((await visit.state()).library_hash, hashBefore)
    return { problem }
  }
  assert.equal(await visit.page.locator('#doubt-dialog').count(), 0, `${name} leaves no doubt`)
  const notes = await visit.page.evaluate(() => globalThis.stridegraphApp.library().notes)
  if (notes.length > 0) {
    const text = await visit.dialogText('library-dialog')
    for (const { message } of notes) assert.ok(text.includes(message), `${message} is not shown`)
    await visit.answer('library-dialog', 'Done')
  }
  return { notes, state: await visit.untilPlanned() }
}

/** Opens a scene; resolves with the state once it is planned. */
async function dropScene(file) {
  const { plans } = await visit.state()
  await visit.drop([file])
  return visit.until((state) => state.plans > plans && state.plan !== null && !state.planning)
}

const topicsOf = (notes) => notes.map(({ topic }) => topic)

/** The JSON of a GLB; throws where it is no valid UTF-8. */
function glbJson(bytes) {
  const length = bytes.readUInt32LE(12)
  return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes.subarray(20, 20 + length)))
}

/** Smallest dot product of two neighbouring keys over all rotations of a GLB. */
function smallestNeighbourDot(bytes) {
  const json = glbJson(bytes)
  const binary = 20 + bytes.readUInt32LE(12) + 8
  let smallest = 1
  for (const { channels, samplers } of json.animations) {
    for (const { sampler, target } of channels) {
      if (target.path !== 'rotation') continue
      const accessor = json.accessors[samplers[sampler].output]
      const view = json.bufferViews[accessor.bufferView]
      const at = binary + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0)
      const stride = view.byteStride ?? 16
      const component = (key, axis) => bytes.readFloatLE(at + key * stride + axis * 4)
      for (let key = 1; key < accessor.count; ++key) {
        let dot = 0
        for (let axis = 0; axis < 4; ++axis) dot += component(key - 1, axis) * component(key, axis)
        smallest = Math.min(smallest, dot)
      }
    }
  }
  return smallest
}

describe('scenes that are dropped', () => {
  it('with start and goal 5 cm apart arrive, or say in a sentence what is amiss', async () => {
    const { plan, sentence } = await dropScene(await caseFile('start_five_cm_from_goal.json'))
    assert.doesNotMatch(sentence, /inf|nan/i)
    if (plan.status === 'arrived') assert.ok(plan.motion_length_m < 1.5, `${plan.motion_length_m} m for 5 cm`)
    else assert.match(sentence, /\./)
  })

  it('with a goal 0.8 m ahead take a step or two', async () => {
    const { plan } = await dropScene(await caseFile('goal_80_cm_ahead.json'))
    assert.equal(plan.status, 'arrived')
    assert.ok(plan.motion_length_m < 1.6, `${plan.motion_length_m} m for 0.8 m`)
  })

  it('with misspelt members show a note for each', async () => {
    await visit.drop([await caseFile('misspelt_members.json')])
    const text = await visit.dialogText('notes-dialog')
    assert.match(text, /line 1.*start\.heading\b.*heading_deg/)
    assert.match(text, /line 1.*constraint\b.*constraints/)
    await visit.screenshot('scene_notes')
    await visit.answer('notes-dialog', 'Done')
    const { scene } = await visit.untilPlanned()
    assert.equal(scene.width, 9)
  })

  it('with walkers that start in one another name both and their distance', async () => {
    const { sentence } = await dropScene(await caseFile('two_start_too_near.json'))
    assert.match(sentence, /^Walkers 1 and 4 .*0\.5\d* m/)
  })

  it('give a GLB whose neighbouring keys never lie on opposite sides', async () => {
    const { plan } = await dropScene(await caseFile('slalom.json'))
    assert.equal(plan.status, 'arrived')
    const { bytes } = await visit.download('#download-glb')
    const smallest = smallestNeighbourDot(bytes)
    assert.ok(smallest >= 0, `a dot product is ${smallest}`)
  })

  it('with names in other scripts show them, and keep them in names of files', async () => {
    const file = await caseFile('names_not_latin.json')
    const { scene } = await dropScene(file)
    assert.equal(scene.name, 'Лабиринт 迷路')
    assert.deepEqual(await visit.untilLettered(), [])
    assert.equal((await visit.download('#save')).name, 'лабиринт_迷路.json')
    assert.equal((await visit.download('#download-glb')).name, 'лабиринт_迷路.glb')
    assert.equal((await visit.download('#download-bvh')).name, 'лабиринт_迷路.bvh')
    // Two characters that change places look otherwise, and neither looks like a question mark.
    const seen = new Set()
    const renamed = (name) => ({ name: file.name, bytes: JSON.stringify({ ...scene, name }) })
    for (const name of ['Лабиринт 迷路', 'Лабиринт 路迷', 'Лабиринт ??', '???????? 迷路']) {
      await dropScene(renamed(name))
      await visit.untilLettered()
      seen.add((await visit.pictureOfName()).toString('base64'))
    }
    assert.equal(seen.size, 4)
    await dropScene(file)
    await visit.untilSettled()
    await visit.screenshot('names_not_latin')
  })
})

describe('clips that are dropped', () => {
  let straight

  it('become a library', async () => {
    await dropScene(straightOn)
    straight = await dropClip('straight.bvh')
    assert.equal(straight.problem, undefined)
    assert.equal(straight.state.plan.status, 'arrived')
  })

  const walkAsStraight = (name, topics) =>
    it(`walk as the sound one: ${name}`, async () => {
      const { notes, state, problem } = await dropClip(name)
      assert.equal(problem, undefined)
      for (const topic of topics) assert.ok(topicsOf(notes).includes(topic), `no note on ${topic}`)
      assert.equal(state.plan.status, 'arrived')
      assert.deepEqual(state.plan.edges, straight.state.plan.edges)
    })
  walkAsStraight('end_sites_with_names.bvh', [])
  walkAsStraight('root_that_stays.bvh', ['travel'])
  walkAsStraight('root_without_channels.bvh', ['travel'])
  walkAsStraight('one_frame_more.bvh', ['rows'])
  walkAsStraight('utf16.bvh', [])
  it('keep the OFFSETs of joints whose position channels are all 0', async () => {
    const { notes, state } = await dropClip('zeros_in_position_channels.bvh')
    assert.ok(topicsOf(notes).includes('skeleton'))
    assert.equal(state.plan.status, 'arrived')
    assert.ok(Math.abs(state.root[1] - straight.state.root[1]) < 0.02)
  })

  walkAsStraight('latin1_names.bvh', ['text'])

  it('with names in Latin-1 give files in UTF-8', async () => {
    const { nodes } = glbJson((await visit.download('#download-glb')).bytes)
    assert.ok(nodes.some(({ name }) => name === 'Hüfte'))
    const { bytes } = await visit.download('#download-bvh')
    assert.match(new TextDecoder('utf-8', { fatal: true }).decode(bytes), /ROOT Hüfte/)
  })

  const isRefused = (name, pattern) =>
    it(`are refused with line, found and expected: ${name}`, async () => {
      const { problem } = await dropClip(name)
      assert.ok(problem, 'it was not refused')
      assert.match(problem, pattern)
      assert.match(problem, /found/)
      assert.match(problem, /expected/)
    })
  isRefused('rows_with_three_numbers_more.bvh', /rows_with_three_numbers_more\.bvh:12\d.*63.*60/s)
  isRefused('short_row.bvh', /short_row\.bvh:122\b.*57.*60/s)

  it('with frame times in milliseconds are read as such, or refused, at once', async () => {
    const { notes, state, problem } = await dropClip('frame_time_in_ms.bvh')
    if (problem) assert.match(problem, /frame_time_in_ms\.bvh:119.*33\.3/s)
    else assert.ok(topicsOf(notes).includes('time') && state.plan !== null)
  })
})
