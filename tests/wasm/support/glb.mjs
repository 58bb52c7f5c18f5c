// A binary glTF taken apart, and its skinned bodies placed as a viewer places them.

export function jsonOf(glb) {
  const view = new DataView(glb.buffer, glb.byteOffset)
  return JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + view.getUint32(12, true))))
}

const components = { SCALAR: 1, VEC3: 3, VEC4: 4, MAT4: 16 }
const arrays = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array }

/** The numbers of an accessor, a typed array. */
export function floatsOf(glb, accessor) {
  const json = jsonOf(glb)
  const { bufferView, componentType, count, type } = json.accessors[accessor]
  const jsonLength = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true)
  const begin = 28 + jsonLength + (json.bufferViews[bufferView].byteOffset ?? 0)
  const Numbers = arrays[componentType]
  const length = count * components[type]
  return new Numbers(glb.slice(begin, begin + length * Numbers.BYTES_PER_ELEMENT).buffer)
}

const turned = ([x, y, z, w], [a, b, c]) => {
  const u = [y * c - z * b, z * a - x * c, x * b - y * a]
  const v = [y * u[2] - z * u[1], z * u[0] - x * u[2], x * u[1] - y * u[0]]
  return [a + 2 * (w * u[0] + v[0]), b + 2 * (w * u[1] + v[1]), c + 2 * (w * u[2] + v[2])]
}
const product = ([x, y, z, w], [a, b, c, d]) => [
  w * a + x * d + y * c - z * b,
  w * b - x * c + y * d + z * a,
  w * c + x * b - y * a + z * d,
  w * d - x * a - y * b - z * c,
]
const sum = (a, b) => a.map((number, i) => number + b[i])

/** World rotation and place of every node at a frame of the only animation. */
function placements(json, keys, frame) {
  const placed = []
  const place = (index, rotation, at) => {
    const node = json.nodes[index]
    const key = (path, size) => keys.get(`${index} ${path}`)?.slice(frame * size, frame * size + size)
    const own = [...(key('rotation', 4) ?? node.rotation ?? [0, 0, 0, 1])]
    const offset = [...(key('translation', 3) ?? node.translation ?? [0, 0, 0])]
    placed[index] = { rotation: product(rotation, own), at: sum(at, turned(rotation, offset)) }
    for (const child of node.children ?? []) place(child, placed[index].rotation, placed[index].at)
  }
  for (const top of json.scenes[0].nodes) place(top, [0, 0, 0, 1], [0, 0, 0])
  return placed
}

/** Heights of the lowest and of the highest vertex of the first body, frame by frame, metres. */
export function lowestVertices(glb) {
  const json = jsonOf(glb)
  const [{ channels, samplers }] = json.animations
  const keys = new Map()
  for (const { sampler, target } of channels) {
    keys.set(`${target.node} ${target.path}`, floatsOf(glb, samplers[sampler].output))
  }
  const frames = json.accessors[samplers[0].input].count
  const { joints, inverseBindMatrices } = json.skins[0]
  const { attributes } = json.meshes[0].primitives[0]
  const [positions, carriers, weights] = ['POSITION', 'JOINTS_0', 'WEIGHTS_0'].map((name) =>
    floatsOf(glb, attributes[name]),
  )
  const matrices = floatsOf(glb, inverseBindMatrices)
  const inJoint = (m, [x, y, z]) =>
    [0, 1, 2].map(
      (row) =>
        matrices[16 * m + row] * x +
        matrices[16 * m + 4 + row] * y +
        matrices[16 * m + 8 + row] * z +
        matrices[16 * m + 12 + row],
    )
  // What does not change from frame to frame: where each vertex lies in the axes of its joints.
  const vertices = []
  for (let v = 0; v < positions.length / 3; ++v) {
    const shares = [0, 1, 2, 3].filter((k) => weights[4 * v + k] > 0)
    vertices.push(
      shares.map((k) => {
        const carrier = carriers[4 * v + k]
        const point = inJoint(carrier, [...positions.slice(3 * v, 3 * v + 3)])
        return { node: joints[carrier], weight: weights[4 * v + k] / 255, point }
      }),
    )
  }
  const lowest = []
  const highest = []
  for (let frame = 0; frame < frames; ++frame) {
    const placed = placements(json, keys, frame)
    const heights = vertices.map((shares) =>
      shares.reduce((y, { node, weight, point }) => {
        const { rotation, at } = placed[node]
        return y + weight * (at[1] + turned(rotation, point)[1])
      }, 0),
    )
    lowest.push(Math.min(...heights))
    highest.push(Math.max(...heights))
  }
  return { lowest, highest }
}
