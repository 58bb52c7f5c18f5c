// Loads the app and what it needs, shows how far it is, and says in a sentence what is missing.
import { AppBridge } from './bridge.mjs'
import { connectInput } from './input.mjs'
import { connectMenu } from './menu.mjs'
import { Progress, fetchBytes } from './fetching.mjs'

const loading = document.getElementById('loading')
const loadingText = document.getElementById('loading-text')
const loadingBar = document.getElementById('loading-bar')
const canvas = document.getElementById('view')

let hasGivenUp = false

function giveUp(sentence) {
  hasGivenUp = true
  loading.classList.remove('done')
  loading.classList.add('failed')
  loading.setAttribute('role', 'alert')
  loadingText.textContent = sentence
}

function whatIsMissing() {
  if (typeof WebAssembly !== 'object') {
    return 'Stridegraph needs WebAssembly, which this browser does not offer.'
  }
  const probe = document.createElement('canvas').getContext('webgl2')
  if (!probe) return 'Stridegraph needs WebGL 2, which this browser does not offer or has switched off.'
  probe.getExtension('WEBGL_lose_context')?.loseContext()
  return ''
}

function addScript(address) {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script')
    script.src = address
    script.onload = resolve
    script.onerror = () => reject(new Error(`${address} cannot be loaded.`))
    document.head.append(script)
  })
}

/** A font is a matter of taste: without one the app falls back to its own. */
async function optionalBytes(address, progress) {
  try {
    return await fetchBytes(address, progress)
  } catch {
    return new Uint8Array()
  }
}

async function start() {
  const missing = whatIsMissing()
  if (missing) return giveUp(missing)
  const progress = new Progress((share, megabytes) => {
    if (hasGivenUp) return
    loadingBar.value = share
    loadingText.textContent = `Loading… ${megabytes} MB`
  })
  const [wasmBinary, library, font] = await Promise.all([
    fetchBytes('app.wasm', progress),
    fetchBytes('assets/default.sgraph', progress),
    optionalBytes('assets/Inter-Medium.otf', progress),
    addScript('app.js'),
  ])
  loadingText.textContent = 'Starting…'
  const bridge = new AppBridge(canvas)
  await bridge.create(globalThis.createStridegraphApp, wasmBinary)
  const reduced = matchMedia('(prefers-reduced-motion: reduce)').matches
  const dark = matchMedia('(prefers-color-scheme: dark)').matches
  bridge.start({ playsAtOnce: !reduced, dark })
  if (font.length > 0) bridge.setFont(font)
  bridge.openLibrary(library, 'assets/default.sgraph')
  connectInput(canvas, bridge)
  await connectMenu(bridge, { dark })
  bridge.run()
  globalThis.stridegraphApp = Object.freeze({
    state: () => bridge.state(),
    pointOf: (x, z) => bridge.pointOf(x, z),
    library: () => bridge.library(),
    lettering: () => bridge.lettering(),
  })
  loading.classList.add('done')
  canvas.focus({ preventScroll: true })
}

start().catch((problem) => giveUp(`Stridegraph could not start: ${problem.message}`))

if ('serviceWorker' in navigator) {
  const register = () => navigator.serviceWorker.register('service_worker.js', { updateViaCache: 'none' })
  // Without it the page works all the same, just not offline.
  addEventListener('load', () => register().catch(() => {}))
}
