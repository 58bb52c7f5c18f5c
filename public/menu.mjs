// The bar above the view: samples, files, sharing, downloads, appearance.
import { connectDownloads } from './downloads.mjs'
import { FileOpener, connectFiles } from './files.mjs'
import { LibraryView } from './library_view.mjs'

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

async function loadSamples(bridge) {
  const response = await fetch('scenes/index.json')
  if (!response.ok) throw new Error(`scenes/index.json cannot be loaded (status ${response.status}).`)
  const samples = await response.json()
  const menu = by('samples')
  for (const { file, title } of samples) menu.append(new Option(title, file))
  const open = async (file) => {
    const answer = await fetch(`scenes/${file}`)
    if (!answer.ok) return bridge.say(`The sample ${file} cannot be loaded (status ${answer.status}).`, true)
    const problem = bridge.openScene(new Uint8Array(await answer.arrayBuffer()), file)
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

function connectNew(bridge) {
  by('new').addEventListener('click', () => {
    bridge.openScene(new TextEncoder().encode(JSON.stringify(NEW_SCENE)), 'new room')
    by('samples').selectedIndex = 0
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
  connectNew(bridge)
  connectDownloads(bridge)
  connectFiles(new FileOpener(bridge, new LibraryView(bridge)))
  const samples = await loadSamples(bridge)
  for (const id of ['samples', 'new', 'open', 'save', 'library', 'share']) by(id).disabled = false
  if (samples.first) {
    by('samples').value = samples.first
    await samples.open(samples.first)
  }
  openAddress(bridge)
  addEventListener('hashchange', () => openAddress(bridge))
}
