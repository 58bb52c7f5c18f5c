import assert from 'node:assert/strict'
import { after, before, describe, it } from 'node:test'
import { defaultLibraryBytes, engine, refusalOf, smallRoom } from './support/engine.mjs'

const reportMembers = [
  'status',
  'seed',
  'planner',
  'search',
  'radius_m',
  'goal_radius_m',
  'units_per_metre',
  'path_ms',
  'motion_ms',
  'synthesis_ms',
  'total_ms',
  'path_length_m',
  'motion_length_m',
  'duration_s',
  'frames',
  'expansions',
  'transitions',
  'edges',
  'clearance_m',
  'foot_skate_cm_s',
  'foot_skate_source_cm_s',
  'penetration_cm',
  'contacts',
  'feet_corrected',
  'feet_left_alone',
  'joint_speed_ratio',
  'joint_speed_ratio_at',
  'joint_accel_ratio',
  'joint_accel_ratio_at',
  'seams',
  'library_hash',
]

/** An open room, to be crossed along its middle. */
const longRoom = () => ({
  version: 1,
  width: 18,
  depth: 12,
  obstacles: [],
  start: { x: 2, z: 6, heading_deg: 90 },
  goal: { x: 16, z: 6 },
})

let library
before(() => {
  library = engine.openLibrary(defaultLibraryBytes)
})
after(() => library.delete())

describe('plan', () => {
  it('arrives, and every array has the shape that its type says', () => {
    const walk = library.plan(smallRoom())
    const joints = walk.joints.length
    assert.equal(walk.status, 'arrived')
    assert.ok(walk.frames > 30)
    assert.equal(walk.positions.length, walk.frames * joints * 3)
    assert.equal(walk.rotations.length, walk.frames * joints * 4)
    assert.equal(walk.blended.length, walk.frames)
    assert.equal(walk.contacts.length, walk.frames)
    assert.equal(walk.path.length % 2, 0)
    assert.equal(walk.roadmap.length % 4, 0)
    assert.equal(walk.fps, library.info.fps)
  })

  it('begins at the start and ends within the goal radius', () => {
    const { positions, joints, frames, path } = library.plan(smallRoom(), { goalRadius: 0.3 })
    const last = (frames - 1) * joints.length * 3
    assert.ok(Math.hypot(positions[0] - 2, positions[2] - 4) < 0.01)
    assert.ok(Math.hypot(positions[last] - 6, positions[last + 2] - 4) < 0.3 + 1e-4)
    assert.deepEqual([...path.slice(0, 2)], [2, 4])
    assert.deepEqual([...path.slice(-2)], [6, 4])
  })

  it('places joints where their rotations and offsets put them', () => {
    const { positions, rotations, joints, frames } = library.plan(smallRoom())
    const world = []
    for (const frame of [0, frames >> 1, frames - 1]) {
      joints.forEach(({ parent, offset }, index) => {
        const local = rotations.subarray((frame * joints.length + index) * 4).slice(0, 4)
        const at = positions.subarray((frame * joints.length + index) * 3).slice(0, 3)
        if (parent < 0) {
          world[index] = { rotation: local, position: at }
          return
        }
        const from = world[parent]
        const moved = rotate(from.rotation, offset)
        const position = from.position.map((value, axis) => value + moved[axis])
        position.forEach((value, axis) => assert.ok(Math.abs(value - at[axis]) < 1e-4, joints[index].name))
        world[index] = { rotation: multiply(from.rotation, local), position }
      })
    }
  })

  it('reports all that the program reports', () => {
    const { report, frames } = library.plan(smallRoom(), {
      seed: 7,
      search: 'thesis',
      planner: 'rrt-connect',
    })
    for (const member of reportMembers) assert.ok(member in report, member)
    assert.equal(report.seed, 7)
    assert.equal(report.search, 'thesis')
    assert.equal(report.planner, 'rrt-connect')
    assert.equal(report.frames, frames)
    assert.equal(report.library_hash, library.info.hash)
  })

  it('measures time', () => {
    assert.ok(library.plan(smallRoom()).report.total_ms > 0)
  })

  it('gives the same walk for the same seed, from an object or its text', () => {
    const first = library.plan(smallRoom(), { seed: 3 })
    const second = library.plan(JSON.stringify(smallRoom()), { seed: 3 })
    assert.deepEqual(first.report.edges, second.report.edges)
    assert.deepEqual(first.positions, second.positions)
  })

  it('answers with a status where there is no way', () => {
    const sealed = { ...smallRoom(), obstacles: [{ x: 4, z: 4, width: 0.5, depth: 8 }] }
    const blockedStart = { ...smallRoom(), start: { x: 4, z: 4 } }
    const blockedGoal = { ...smallRoom(), goal: { x: 4, z: 4 } }
    for (const [scene, status] of [
      [sealed, 'no_path'],
      [blockedStart, 'start_blocked'],
      [blockedGoal, 'goal_blocked'],
    ]) {
      const walk = library.plan(scene)
      assert.equal(walk.status, status)
      assert.equal(walk.frames, 0)
      assert.equal(walk.positions.length, 0)
    }
  })

  it('gives copies, which stay when memory grows and when the library is deleted', () => {
    const own = engine.openLibrary(defaultLibraryBytes)
    const walk = own.plan(smallRoom())
    const kept = walk.positions.slice()
    const more = Array.from({ length: 8 }, () => engine.openLibrary(defaultLibraryBytes))
    more.forEach((one) => one.delete())
    own.delete()
    assert.deepEqual(walk.positions, kept)
    assert.notEqual(walk.positions.buffer.byteLength, engine.memory.heapBytes)
    assert.match(walk.toBvh(), /^HIERARCHY/)
  })

  it('gives the walks of further walkers the same members, and files of their own', () => {
    const walkers = [{ start: { x: 1, z: 1.5 }, goal: { x: 7, z: 1.5 } }]
    const walk = library.plan({ ...smallRoom(), walkers })
    assert.equal(walk.others.length, 1)
    const [other] = walk.others
    assert.deepEqual(Object.keys(other).sort(), Object.keys(walk).sort())
    assert.equal(other.status, 'arrived')
    assert.equal(other.positions.length, other.frames * other.joints.length * 3)
    assert.ok(Math.hypot(other.positions[0] - 1, other.positions[2] - 1.5) < 0.01)
    assert.match(other.toBvh(), /^HIERARCHY/)
    assert.notEqual(other.toBvh(), walk.toBvh())
    assert.equal(new TextDecoder().decode(other.toGlb().subarray(0, 4)), 'glTF')
    assert.deepEqual(library.plan(smallRoom()).others, [])
  })

  it('refuses constraints that no walk can keep to', () => {
    const constraints = { min_speed_m_s: 2, max_speed_m_s: 1 }
    assert.match(
      refusalOf(() => library.plan({ ...smallRoom(), constraints })).message,
      /min_speed_m_s: found 2/,
    )
  })

  it('gives values that a worker may post', () => {
    const { positions, joints, report } = structuredClone(library.plan(smallRoom()))
    assert.ok(positions.length > 0 && joints.length > 0 && report.edges.length > 0)
  })
})

function multiply([aw, ax, ay, az], [bw, bx, by, bz]) {
  return [
    aw * bw - ax * bx - ay * by - az * bz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
  ]
}

function rotate([w, x, y, z], [vx, vy, vz]) {
  const [, ...rotated] = multiply(multiply([w, x, y, z], [0, vx, vy, vz]), [w, -x, -y, -z])
  return rotated
}

describe('replan', () => {
  it('goes on from the present pose around a new wall', () => {
    const scene = longRoom()
    const walk = library.plan(scene)
    scene.obstacles = [{ x: 9, z: 6, width: 1, depth: 4 }]
    const onward = library.replan(scene, 2)
    assert.equal(onward.status, 'arrived')
    assert.equal(onward.kept, false)
    assert.ok(onward.report.clearance_m >= -1e-6)
    const shown = Math.floor(2 * walk.fps) * walk.joints.length * 3
    assert.deepEqual(onward.positions.slice(0, shown), walk.positions.slice(0, shown))
  })

  it('keeps a walk that an edit does not concern', () => {
    const scene = longRoom()
    const walk = library.plan(scene)
    scene.obstacles = [{ x: 9, z: 1, width: 1, depth: 1 }]
    const onward = library.replan(scene, 1)
    assert.equal(onward.kept, true)
    assert.equal(onward.frames, walk.frames)
  })

  it('names a time that the walk does not have', () => {
    library.plan(longRoom())
    assert.match(
      refusalOf(() => library.replan(longRoom(), 1000)).message,
      /atSeconds is 1000, expected 0 to the walk's/,
    )
  })

  it('needs a walk under way', () => {
    const fresh = engine.openLibrary(defaultLibraryBytes)
    assert.match(refusalOf(() => fresh.replan(longRoom(), 0)).message, /found no walk under way/)
    fresh.delete()
  })
})

describe('improve', () => {
  it('finds walks that are no longer, the same every time', () => {
    const scene = longRoom()
    scene.obstacles = [{ x: 9, z: 5, width: 1, depth: 7 }]
    const first = library.plan(scene)
    const better = library.plan(scene, { improve: 20000 })
    assert.ok(better.report.expansions > first.report.expansions)
    assert.deepEqual(better.report.edges, library.plan(scene, { improve: 20000 }).report.edges)
    assert.deepEqual(library.plan(scene, { improve: 20000, until: 10 }).report.edges, first.report.edges)
    assert.throws(() => library.plan(scene, { until: 0.5 }), /until: found 0.5, expected 1 to 10/)
  })
})

/** A long room with a wall to walk round. */
function roomWithWall() {
  return { ...longRoom(), obstacles: [{ x: 9, z: 5, width: 1, depth: 7 }] }
}

describe('startPlan', () => {
  const improving = { improve: 20000 }

  it('has a walk at once, and step by step comes to what plan gives', () => {
    const plan = library.startPlan(roomWithWall(), improving)
    const first = plan.walk
    assert.equal(plan.progress, 0)
    assert.deepEqual(first.positions, library.plan(roomWithWall()).positions)
    let steps = 0
    for (let least = 0; plan.step(); ++steps) {
      assert.ok(plan.progress >= least && plan.progress <= 1)
      least = plan.progress
    }
    assert.ok(steps >= 5, `${steps} steps`)
    assert.equal(plan.progress, 1)
    const last = plan.finish()
    const atOnce = library.plan(roomWithWall(), improving)
    assert.deepEqual(last.positions, atOnce.positions)
    assert.equal(last.report.expansions, atOnce.report.expansions)
    assert.ok(last.report.motion_length_m < first.report.motion_length_m)
  })

  it('is over at once where nothing is to be improved', () => {
    const plan = library.startPlan(roomWithWall())
    assert.equal(plan.progress, 1)
    assert.equal(plan.step(), false)
    assert.equal(plan.finish().status, 'arrived')
    const none = library.startPlan({ ...roomWithWall(), goal: { x: 9, z: 5 } }, improving)
    assert.equal(none.step(), false)
    assert.equal(none.finish().status, 'goal_blocked')
  })

  it('refuses all use after cancel, which may be called twice', () => {
    const plan = library.startPlan(roomWithWall(), improving)
    const { walk } = plan
    plan.cancel()
    plan.cancel()
    assert.match(refusalOf(() => plan.step()).message, /the plan was deleted/)
    assert.equal(walk.status, 'arrived')
  })

  it('goes on when its library is deleted', () => {
    const own = engine.openLibrary(defaultLibraryBytes)
    const plan = own.startPlan(roomWithWall(), improving)
    own.delete()
    assert.equal(plan.finish().status, 'arrived')
  })

  it('goes on from the pose shown, too', () => {
    const walk = library.plan(roomWithWall())
    const plan = library.startReplan({ ...roomWithWall(), goal: { x: 16, z: 4 } }, 2, improving)
    const onward = plan.finish()
    assert.equal(onward.status, 'arrived')
    const shown = Math.floor(2 * walk.fps) * walk.joints.length * 3
    assert.deepEqual(onward.positions.slice(0, shown), walk.positions.slice(0, shown))
  })
})

describe('planAsync', () => {
  const improving = { improve: 20000 }

  it('shows the first walk at once, better ones later, and resolves with the best', async () => {
    const walks = []
    const progress = []
    const run = {
      onWalk: (walk) => walks.push(walk),
      onProgress: (share) => progress.push(share),
      sliceMs: 1,
    }
    const planned = library.planAsync(roomWithWall(), improving, run)
    assert.equal(walks.length, 1)
    const best = await planned
    assert.ok(walks.length >= 2, `${walks.length} walks`)
    assert.deepEqual(best.positions, walks.at(-1).positions)
    assert.deepEqual(best.positions, library.plan(roomWithWall(), improving).positions)
    assert.ok(progress.length >= 2 && progress.at(-1) === 1)
  })

  it('is given up by its signal, and leaves nothing behind', async () => {
    const controller = new AbortController()
    const planned = library.planAsync(roomWithWall(), improving, {
      signal: controller.signal,
      onProgress: () => controller.abort(new Error('enough')),
      sliceMs: 0,
    })
    await assert.rejects(planned, /enough/)
    await assert.rejects(library.planAsync(roomWithWall(), {}, { signal: controller.signal }), /enough/)
  })
})

describe('walkers', () => {
  it('pass one another without contact', () => {
    const scene = longRoom()
    scene.walkers = [{ start: { x: 16, z: 6, heading_deg: 270 }, goal: { x: 2, z: 6 } }]
    const walk = library.plan(scene)
    const other = walk.others[0]
    assert.equal(walk.status, 'arrived')
    assert.equal(other.status, 'arrived')
    const placeOf = (one, frame) => {
      const at = Math.min(frame, one.frames - 1) * one.joints.length * 3
      return [one.positions[at], one.positions[at + 2]]
    }
    for (let frame = 0; frame < Math.max(walk.frames, other.frames); frame++) {
      const [ax, az] = placeOf(walk, frame)
      const [bx, bz] = placeOf(other, frame)
      assert.ok(Math.hypot(ax - bx, az - bz) > 0.8, `at ${frame}`)
    }
  })
})
