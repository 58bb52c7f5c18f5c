// A small body that walks, as BVH text: enough to build libraries of a few dozen frames.

const degrees = 180 / Math.PI

const leg = (side, x) => `
  JOINT ${side}UpLeg { OFFSET ${x} -4 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT ${side}Leg { OFFSET 0 -42 0 CHANNELS 3 Zrotation Xrotation Yrotation
      JOINT ${side}Foot { OFFSET 0 -42 0 CHANNELS 3 Zrotation Xrotation Yrotation
        End Site { OFFSET 0 -4 14 } } } }`

const hierarchy = (armLength) => `HIERARCHY
ROOT Hips { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine { OFFSET 0 20 0 CHANNELS 3 Zrotation Xrotation Yrotation
    JOINT RightArm { OFFSET -18 30 0 CHANNELS 3 Zrotation Xrotation Yrotation
      End Site { OFFSET -${armLength} 0 0 } }
    JOINT Head { OFFSET 0 40 0 CHANNELS 3 Zrotation Xrotation Yrotation
      End Site { OFFSET 0 22 0 } } }${leg('Left', 9)}${leg('Right', -9)}
}`

/** Hierarchies are written in short above; files have a line for each brace and keyword. */
const broken = (text) => text.replace(/\s*([{}])\s*/g, '\n$1\n').replace(/ CHANNELS/g, '\nCHANNELS')

/**
 * Frames at 30 Hz, one stride in 30 frames. With `lean`, degrees, the body leans over by as much from the first frame to
 * the last, so that no moment comes back.
 */
export function walkerBvh({ frames = 90, lean = 0, armLength = 50, firstRow } = {}) {
  const rows = []
  for (let frame = 0; frame < frames; ++frame) {
    const phase = (frame * 2 * Math.PI) / 30
    const swing = 0.4 * Math.sin(phase) * degrees
    const kneeOf = (shift) => 20 + 20 * Math.cos(phase + shift)
    const leaning = frames > 1 ? (lean * frame) / (frames - 1) : 0
    const values = [0, 90 + 1.5 * Math.cos(2 * phase), frame * 4, 0, 0, 0]
    values.push(leaning, 0, 0, 0, 0, 0, 0, 0, 0)
    values.push(0, swing, 0, 0, kneeOf(0), 0, 0, 0, 0)
    values.push(0, -swing, 0, 0, kneeOf(Math.PI), 0, 0, 0, 0)
    rows.push(values.map((value) => value.toFixed(4)).join(' '))
  }
  if (firstRow !== undefined) rows[0] = firstRow
  return `${broken(hierarchy(armLength))}\nMOTION\nFrames: ${frames}\nFrame Time: 0.0333333\n${rows.join('\n')}\n`
}

/** Two strides and a half that repeat: the smallest clip that connects with itself. */
export const walkerClip = () => ({ name: 'walker.bvh', text: walkerBvh() })
