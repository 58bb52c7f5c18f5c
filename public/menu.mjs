// The bar above the view: samples, files, sharing, downloads, appearance.
import { buildLibrary } from './library_builder.mjs'

const by = (id) => document.getElementById(id)

const NEW_SCENE = {
  version: 1,
  name: 'New room',
  width: 12,
  depth: 9,
  obstacles: [],
  start: { x: 2, z: 4.5, heading_deg: 90 },
  goal: { x: 10, z: 4.5, heading_deg: 90 },
}

function download(bytes, name, type) {
  const address = URL.createObjectURL(new Blob([bytes], { type }))
  const anchor = document.createElement('a')
  anchor.href = address
  anchor.download = name
  anchor.click()
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
}

/** A file name made of the scene's name and an ending. */
function fileName(bridge, ending) {
  const name = bridge.state().scene.name || 'scene'
  return `${
    name
      .toLowerCase()
      .replace(/[^a-z0-9]+/g, '_')
      .replace(/^_+|_+$/g, '') || 'scene'
  }${ending}`
}

/** BVH holds one body: further walkers' files follow, named as the program names them. */
function downloadBvh(bridge) {
  const count = 1 + (bridge.state().scene.walkers?.length ?? 0)
  for (let walker = 0; walker < count; ++walker) {
    const bytes = bridge.walkBvh(walker)
    const ending = walker === 0 ? '.bvh' : `_${walker + 1}.bvh`
    if (bytes.length > 0) download(bytes, fileName(bridge, ending), 'text/plain')
  }
}

async function loadSamples(bridge) {
  const response = await fetch('scenes/index.json')
  if (!response.ok) throw new Error(`scenes/index.json cannot be loaded (status ${response.status}).`)
  const samples = await response.json()
  const menu = by('samples')
  for (const { file, title } of samples) menu.append(new Option(title, file))
  const open = async (file) => {
    const answer = await fetch(`scenes/${file}`)
    if (!answer.ok) return bridge.say(`The sample ${file} cannot be loaded (status ${answer.status}).`, true)
    const problem = bridge.openScene(await answer.text(), file)
    if (problem) bridge.say(problem, true)
  }
  menu.addEventListener('change', () => open(menu.value))
  const wanted = menu.dataset.first
  const first = samples.find(({ file }) => file === wanted) ?? samples[0]
  return { open, first: first?.file }
}

/** Opens the scene of the address if it holds one. Whether it does, however that ends. */
function openAddress(bridge) {
  if (location.hash.length < 2) return false
  const problem = bridge.openLink(location.hash)
  if (problem) bridge.say(problem, true)
  if (!problem) by('samples').selectedIndex = 0
  return !problem
}

function connectSharing(bridge) {
  const dialog = by('share-dialog')
  const field = by('share-link')
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(field.value)
      by('share-note').textContent = 'The link is copied. Whoever opens it sees this room and this walk.'
    } catch {
      by('share-note').textContent = 'Copy this link. Whoever opens it sees this room and this walk.'
      field.select()
    }
  }
  by('share').addEventListener('click', () => {
    const address = new URL(location.href)
    address.hash = bridge.link()
    history.replaceState(null, '', address)
    field.value = address.href
    dialog.showModal()
    copy()
  })
  by('share-copy').addEventListener('click', copy)
  by('share-close').addEventListener('click', () => dialog.close())
}

async function openFiles(bridge, files) {
  const clips = files.filter((file) => /\.bvh$/i.test(file.name))
  if (clips.length > 0) return buildLibrary(bridge, clips)
  const [file] = files
  if (!file) return
  if (/\.sgraph$/i.test(file.name)) {
    bridge.openLibrary(new Uint8Array(await file.arrayBuffer()))
    return bridge.say(`${file.name} is the library now.`)
  }
  const problem = bridge.openScene(await file.text(), file.name)
  if (problem) return bridge.say(problem, true)
  by('samples').selectedIndex = 0
}

function connectFiles(bridge) {
  const input = by('file')
  const open = (files) => openFiles(bridge, files).catch((problem) => bridge.say(problem.message, true))
  by('new').addEventListener('click', () => {
    bridge.openScene(JSON.stringify(NEW_SCENE), 'new room')
    by('samples').selectedIndex = 0
  })
  by('open').addEventListener('click', () => input.click())
  input.addEventListener('change', () => {
    open([...input.files])
    input.value = ''
  })
  by('save').addEventListener('click', () =>
    download(bridge.sceneJson(), fileName(bridge, '.json'), 'application/json'),
  )
  by('download-bvh').addEventListener('click', () => downloadBvh(bridge))
  by('download-glb').addEventListener('click', () =>
    download(bridge.walksGlb(), fileName(bridge, '.glb'), 'model/gltf-binary'),
  )
  const main = document.querySelector('main')
  addEventListener('dragover', (event) => {
    event.preventDefault()
    main.classList.add('dropping')
  })
  addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) main.classList.remove('dropping')
  })
  addEventListener('drop', (event) => {
    event.preventDefault()
    main.classList.remove('dropping')
    open([...event.dataTransfer.files])
  })
}

function connectTheme(bridge, dark) {
  const show = (isDark) => {
    document.documentElement.dataset.theme = isDark ? 'dark' : 'light'
    bridge.setDark(isDark)
  }
  let isDark = dark
  show(isDark)
  by('theme').addEventListener('click', () => {
    isDark = !isDark
    show(isDark)
  })
}

function mirrorStatus(bridge) {
  bridge.onStatus = (sentence) => {
    by('status').textContent = sentence
    const walks = bridge.state().walk_seconds > 0
    by('download-bvh').disabled = !walks
    by('download-glb').disabled = !walks
  }
}

/** Fills the menus, and opens the scene of the address or else the first sample. */
export async function connectMenu(bridge, { dark }) {
  mirrorStatus(bridge)
  connectTheme(bridge, dark)
  connectSharing(bridge)
  connectFiles(bridge)
  const samples = await loadSamples(bridge)
  for (const id of ['samples', 'new', 'open', 'save', 'share']) by(id).disabled = false
  if (samples.first) {
    by('samples').value = samples.first
    await samples.open(samples.first)
  }
  openAddress(bridge)
  addEventListener('hashchange', () => openAddress(bridge))
}
