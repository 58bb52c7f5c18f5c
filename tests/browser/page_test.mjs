import assert from 'node:assert/strict'
import { readdir } from 'node:fs/promises'
import { join } from 'node:path'
import { after, before, describe, it } from 'node:test'
import { fileURLToPath } from 'node:url'
import { Visit, startBrowser } from './page_driver.mjs'

let server
before(async () => {
  server = await startBrowser()
})
after(() => server?.stop())

/** Runs one visit; whatever the page logs as an error fails it. */
async function visiting(options, story) {
  const visit = await Visit.start(server, options)
  try {
    await story(visit)
    assert.deepEqual(visit.errors, [])
  } finally {
    await visit.end()
  }
}

describe('the page', () => {
  it('loads its library and says what the walk is like', () =>
    visiting({}, async (visit) => {
      const state = await visit.untilPlanned()
      assert.match(state.library_hash, /^[0-9a-f]{16}$/)
      assert.equal(state.plan.status, 'arrived')
      assert.equal(await visit.page.locator('#status').textContent(), state.sentence)
      assert.match(state.sentence, /Arrives after [0-9.]+ m/)
    }))

  it('plans the labyrinth and walks when play is pressed', () =>
    visiting({}, async (visit) => {
      await visit.openSample('empty.json')
      const { scene, plan, root } = await visit.openSample('labyrinth.json')
      assert.equal(scene.obstacles.length > 5, true)
      assert.equal(plan.status, 'arrived')
      assert.equal(plan.edges.length > 0, true)
      await visit.screenshot('editor')
      await visit.press('Space')
      const walked = await visit.until((state) => state.frame > 45)
      assert.equal(walked.playing, true)
      assert.equal(Math.hypot(walked.root[0] - root[0], walked.root[2] - root[2]) > 0.3, true)
      await visit.press('Space')
      await visit.until((state) => !state.playing)
      await visit.useCamera('2', 'follow')
      await visit.screenshot('walk')
    }))

  it('shows the frame of a figure in the report that is clicked on', () =>
    visiting({}, async (visit) => {
      const { plan } = await visit.openSample('one_obstacle.json')
      assert.equal(plan.arrival_error_m < 0.02, true)
      assert.equal(plan.ends_standing, true)
      assert.deepEqual(
        plan.marks.map((mark) => mark.name),
        ['Joint speed', 'Joint acceleration', 'Widest seam'],
      )
      const frames = plan.marks.map((mark) => mark.frame)
      assert.equal(
        frames.every((frame) => frame > 0 && frame < plan.frames),
        true,
      )
      // The rows lie one below the other at the panel's right; look for them from the top.
      const shown = new Set()
      const box = await visit.canvas.boundingBox()
      for (let y = 300; y < 420; y += 10) {
        await visit.page.mouse.move(box.x + box.width - 60, box.y + y)
        await visit.page.mouse.down()
        await visit.framesPass()
        await visit.page.mouse.up()
        await visit.framesPass()
        shown.add((await visit.state()).frame)
      }
      for (const frame of frames) assert.equal(shown.has(frame), true, `frame ${frame} was not shown`)
      await visit.screenshot('quality')
    }))

  it('shows the plan from above, in the dark', () =>
    visiting({ colorScheme: 'dark' }, async (visit) => {
      await visit.openSample('scattered.json')
      await visit.screenshot('dark')
      await visit.useCamera('3', 'top')
      await visit.screenshot('top')
    }))

  it('is sharp at a device pixel ratio of 2', () =>
    visiting({ deviceScaleFactor: 2 }, async (visit) => {
      await visit.untilPlanned()
      const size = await visit.canvas.evaluate((canvas) => ({
        backing: [canvas.width, canvas.height],
        shown: [canvas.clientWidth, canvas.clientHeight],
      }))
      assert.deepEqual(size.backing, [size.shown[0] * 2, size.shown[1] * 2])
      await visit.untilSettled()
      await visit.screenshot('sharp')
    }))

  it('follows the size of the window', () =>
    visiting({}, async (visit) => {
      await visit.untilPlanned()
      await visit.page.setViewportSize({ width: 900, height: 600 })
      await visit.page.waitForFunction(() => document.getElementById('view').width === 900)
    }))
})

describe('editing', () => {
  it('draws a block, plans around it, and takes it back', () =>
    visiting({}, async (visit) => {
      const first = await visit.openSample('empty.json')
      await visit.useCamera('3', 'top')
      await visit.press('b')
      await visit.until((state) => state.tool === 'block')
      const { start, goal } = first.scene
      const middle = [(start.x + goal.x) / 2, (start.z + goal.z) / 2]
      await visit.dragFloor([middle[0] - 1, middle[1] - 1], [middle[0] + 1, middle[1] + 1])
      const drawn = await visit.until((state) => state.scene.obstacles.length === 1 && !state.planning)
      assert.notDeepEqual(drawn.plan.edges, first.plan.edges)
      const [block] = drawn.scene.obstacles
      assert.ok(Math.abs(block.width - 2) < 0.11 && Math.abs(block.depth - 2) < 0.11)
      assert.ok(Math.abs(block.x * 20 - Math.round(block.x * 20)) < 1e-6, 'sides snap to 0.1 m')
      await visit.press('Control+z')
      const undone = await visit.until((state) => state.scene.obstacles.length === 0 && !state.planning)
      assert.deepEqual(undone.plan.edges, first.plan.edges)
      await visit.press('Control+Shift+Z')
      const redone = await visit.until((state) => state.scene.obstacles.length === 1 && !state.planning)
      assert.deepEqual(redone.plan.edges, drawn.plan.edges)
    }))

  it('moves the goal by dragging, as one step', () =>
    visiting({}, async (visit) => {
      const first = await visit.openSample('empty.json')
      const { goal } = first.scene
      await visit.dragFloor([goal.x, goal.z], [goal.x - 3, goal.z - 2])
      const moved = await visit.until((state) => state.scene.goal.x < goal.x - 2.5 && !state.planning)
      assert.equal(moved.undo_steps, first.undo_steps + 1)
      assert.ok(Math.abs(moved.scene.goal.z - (goal.z - 2)) < 0.11)
    }))

  it('says why there is no walk when the goal is built over', () =>
    visiting({}, async (visit) => {
      const { scene } = await visit.openSample('empty.json')
      await visit.useCamera('3', 'top')
      await visit.press('b')
      await visit.until((state) => state.tool === 'block')
      const { x, z } = scene.goal
      await visit.dragFloor([x - 1.5, z - 1.5], [x + 1.5, z + 1.5])
      const state = await visit.until((now) => now.scene.obstacles.length === 1 && !now.planning)
      assert.equal(state.plan.status, 'goal_blocked')
      assert.match(state.sentence, /goal/i)
      await visit.page.waitForFunction(() => document.getElementById('download-bvh').disabled)
    }))

  it('leaves keys to the bar above the view', () =>
    visiting({}, async (visit) => {
      const first = await visit.untilPlanned()
      await visit.page.locator('#new').focus()
      await visit.page.keyboard.press('b')
      await visit.page.keyboard.press('ArrowRight')
      const state = await visit.state()
      assert.equal(state.tool, first.tool)
      assert.equal(state.frame, first.frame)
    }))
})

describe('what moves', () => {
  it('is drawn by its way, shown where it is at the time, and taken back', () =>
    visiting({}, async (visit) => {
      await visit.openSample('empty.json')
      await visit.useCamera('3', 'top')
      await visit.press('m')
      await visit.until((state) => state.tool === 'moving')
      await visit.dragFloor([8, 2], [8, 6])
      const drawn = await visit.until((state) => state.scene.moving?.length === 1 && !state.planning)
      assert.equal(drawn.scene.moving[0].repeat, 'pingpong')
      assert.deepEqual(drawn.moving[0], [8, 2])
      const later = await visit.playUntil(1.5)
      assert.ok(Math.abs(later.moving[0][1] - (2 + 0.8 * later.seconds)) < 1e-6)
      await visit.screenshot('moving')
      await visit.press('Delete')
      await visit.until((state) => state.scene.moving === undefined)
      await visit.press('Control+z')
      await visit.until((state) => state.scene.moving?.length === 1)
    }))

  it('is the walk itself while the goal is dragged, and playback stays at its time', () =>
    visiting({}, async (visit) => {
      const { scene } = await visit.openSample('empty.json')
      await visit.useCamera('3', 'top')
      const paused = await visit.playUntil(1)
      const { x, z } = scene.goal
      await visit.dragFloorHolding([x, z], [x - 1, z - 2], async () => {
        const held = await visit.until((state) => state.plans > paused.plans + 1)
        assert.equal(held.undo_steps, paused.undo_steps)
        assert.equal(held.seconds, paused.seconds)
        assert.notDeepEqual(held.plan.edges, paused.plan.edges)
        assert.equal(held.went_on, true)
        held.root.forEach((value, axis) => assert.ok(Math.abs(value - paused.root[axis]) < 0.02))
      })
      const dropped = await visit.until((state) => state.undo_steps > paused.undo_steps && !state.planning)
      assert.equal(dropped.seconds, paused.seconds)
      await visit.press('Home')
      await visit.until((state) => !state.went_on && state.seconds === 0)
    }))

  it('is as many walkers as there are', () =>
    visiting({}, async (visit) => {
      const first = await visit.openSample('empty.json')
      await visit.useCamera('3', 'top')
      await visit.press('w')
      await visit.until((state) => state.tool === 'walker')
      await visit.dragFloor([2, 1.5], [8, 1.5])
      const two = await visit.until((state) => state.scene.walkers?.length === 1 && !state.planning)
      assert.deepEqual(two.scene.walkers[0].goal, { x: 8, z: 1.5 })
      assert.equal(two.roots.length, 2)
      assert.ok(Math.hypot(two.roots[1][0] - 2, two.roots[1][2] - 1.5) < 0.1)
      await visit.press('Delete')
      await visit.until((state) => state.scene.walkers === undefined && !state.planning)
      assert.deepEqual((await visit.state()).plan.edges, first.plan.edges)
    }))

  it('leaves an area alone that is drawn to be avoided', () =>
    visiting({}, async (visit) => {
      await visit.openSample('empty.json')
      await visit.useCamera('3', 'top')
      await visit.press('a')
      await visit.until((state) => state.tool === 'area')
      await visit.dragFloor([4, 2], [6, 4])
      const drawn = await visit.until((state) => state.scene.constraints?.areas.length === 1)
      assert.equal(drawn.scene.constraints.areas[0].kind, 'avoid')
    }))
})

describe('links', () => {
  it('open to the same room and the same edges', () =>
    visiting({}, async (visit) => {
      const shared = await visit.openSample('one_obstacle.json')
      await visit.page.click('#share')
      const link = await visit.page.inputValue('#share-link')
      assert.match(link, /#s=/)
      assert.equal(await visit.page.evaluate(() => navigator.clipboard.readText()), link)
      await visiting({ fragment: link.slice(link.indexOf('#')) }, async (guest) => {
        await guest.until((state) => state.scene.name === shared.scene.name)
        const state = await guest.untilPlanned()
        assert.deepEqual(state.scene, shared.scene)
        assert.deepEqual(state.plan.edges, shared.plan.edges)
      })
    }))

  it('that are damaged leave the scene alone and say so', () =>
    visiting({}, async (visit) => {
      const first = await visit.openSample('one_obstacle.json')
      await visit.page.click('#share')
      const link = await visit.page.inputValue('#share-link')
      await visit.page.click('#share-close')
      const at = link.length - 12
      const damaged = link.slice(0, at) + (link[at] === 'A' ? 'B' : 'A') + link.slice(at + 1)
      await visit.page.evaluate((hash) => (location.hash = hash), damaged.slice(damaged.indexOf('#')))
      const state = await visit.until((now) => now.notice !== '')
      assert.match(state.notice, /link/i)
      assert.deepEqual(state.scene, first.scene)
      await visit.screenshot('damaged_link')
    }))
})

/** The synthesised clips that the default library is built from. */
async function gaitClips() {
  const folder = fileURLToPath(new URL('../../build/gait/', import.meta.url))
  const names = (await readdir(folder)).filter((name) => name.endsWith('.bvh'))
  return names.map((name) => join(folder, name))
}

describe('files', () => {
  it('are the walk as BVH and GLB, and the scene', () =>
    visiting({}, async (visit) => {
      const { scene } = await visit.openSample('one_obstacle.json')
      const fetchFile = async (button) => {
        const [download] = await Promise.all([visit.page.waitForEvent('download'), visit.page.click(button)])
        const chunks = []
        for await (const chunk of await download.createReadStream()) chunks.push(chunk)
        return Buffer.concat(chunks)
      }
      assert.match((await fetchFile('#download-bvh')).toString().slice(0, 9), /HIERARCHY/)
      assert.equal((await fetchFile('#download-glb')).subarray(0, 4).toString(), 'glTF')
      assert.deepEqual(JSON.parse((await fetchFile('#save')).toString()), scene)
    }))

  it('are one BVH for each of several walkers, and one GLB of all', () =>
    visiting({}, async (visit) => {
      const { scene } = await visit.openSample('crossing.json')
      const downloads = []
      visit.page.on('download', (download) => downloads.push(download))
      await visit.page.click('#download-bvh')
      const walkers = 1 + scene.walkers.length
      for (let i = 0; i < 100 && downloads.length < walkers; ++i) await visit.page.waitForTimeout(50)
      const names = downloads.map((download) => download.suggestedFilename())
      assert.equal(names.length, walkers)
      assert.match(names[0], /^[a-z_0-9]+\.bvh$/)
      assert.equal(names.at(-1), names[0].replace('.bvh', `_${walkers}.bvh`))
      const [glb] = await Promise.all([
        visit.page.waitForEvent('download'),
        visit.page.click('#download-glb'),
      ])
      const chunks = []
      for await (const chunk of await glb.createReadStream()) chunks.push(chunk)
      assert.ok(Buffer.concat(chunks).includes(`"walker_${walkers}"`))
    }))

  it('of motion capture become a library, built in a worker', () =>
    visiting({}, async (visit) => {
      const first = await visit.openSample('one_obstacle.json')
      const clips = await gaitClips()
      await visit.page.setInputFiles('#file', clips)
      const notice = `${clips.length} clips`
      const built = await visit.until((state) => state.notice.includes(notice) && !state.planning)
      assert.equal(built.plan.status, 'arrived')
      // The shipped library was built from the same clips, at a smaller threshold.
      assert.notDeepEqual(built.plan.edges, first.plan.edges)
    }))

  it('of motion capture that are damaged are refused with the place', () =>
    visiting({}, async (visit) => {
      const first = await visit.untilPlanned()
      const file = {
        name: 'broken.bvh',
        mimeType: 'text/plain',
        buffer: Buffer.from('HIERARCHY\nROOT hip\n'),
      }
      await visit.page.setInputFiles('#file', file)
      assert.match(await visit.dialogText('problem-dialog'), /broken\.bvh:\d+:\d+\s+found/)
      await visit.answer('problem-dialog', 'Close')
      assert.deepEqual((await visit.state()).plan, first.plan)
    }))

  it('that are no scene are refused with a sentence', () =>
    visiting({}, async (visit) => {
      const first = await visit.untilPlanned()
      const file = { name: 'broken.json', mimeType: 'application/json', buffer: Buffer.from('{"width": 3') }
      await visit.page.setInputFiles('#file', file)
      assert.match(await visit.dialogText('problem-dialog'), /broken\.json/)
      await visit.answer('problem-dialog', 'Close')
      assert.deepEqual((await visit.state()).scene, first.scene)
    }))
})

describe('what is missing', () => {
  const lastWords = (visit) => visit.page.locator('#loading.failed #loading-text').textContent()

  it('is said in a sentence: WebGL 2', () =>
    visiting(
      {
        prepare: (page) =>
          page.addInitScript(() => {
            HTMLCanvasElement.prototype.getContext = () => null
          }),
      },
      async (visit) => assert.match(await lastWords(visit), /needs WebGL 2/),
    ))

  it('is said in a sentence: the library', async () => {
    const visit = await Visit.start(server, {
      prepare: (page) => page.route('**/default.sgraph', (route) => route.fulfill({ status: 404 })),
    })
    assert.match(await lastWords(visit), /default\.sgraph cannot be loaded/)
    await visit.end()
  })

  it('is nothing for those who come again without a network', async () => {
    const visit = await Visit.start(server, { serviceWorkers: 'allow' })
    await visit.untilPlanned()
    await visit.page.evaluate(async () => (await navigator.serviceWorker.ready).active !== null)
    await visit.context.setOffline(true)
    await visit.page.reload()
    const state = await visit.untilPlanned()
    assert.equal(state.plan.status, 'arrived')
    await visit.end()
  })
})
