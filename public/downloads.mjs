// Files that the page gives away: walks and scenes, named after the scene.
import { fileStem } from './file_names.mjs'

const by = (id) => document.getElementById(id)

export function download(bytes, name, type) {
  const address = URL.createObjectURL(new Blob([bytes], { type }))
  const anchor = document.createElement('a')
  anchor.href = address
  anchor.download = name
  anchor.click()
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
}

const fileName = (bridge, ending) => fileStem(bridge.state().scene.name ?? '', 'scene') + ending

/** BVH holds one body: further walkers' files follow, named as the program names them. */
function downloadBvh(bridge) {
  const count = 1 + (bridge.state().scene.walkers?.length ?? 0)
  for (let walker = 0; walker < count; ++walker) {
    const bytes = bridge.walkBvh(walker)
    const ending = walker === 0 ? '.bvh' : `_${walker + 1}.bvh`
    if (bytes.length > 0) download(bytes, fileName(bridge, ending), 'text/plain')
  }
}

export function connectDownloads(bridge) {
  by('save').addEventListener('click', () =>
    download(bridge.sceneJson(), fileName(bridge, '.json'), 'application/json'),
  )
  by('download-bvh').addEventListener('click', () => downloadBvh(bridge))
  by('download-glb').addEventListener('click', () =>
    download(bridge.walksGlb(), fileName(bridge, '.glb'), 'model/gltf-binary'),
  )
}
