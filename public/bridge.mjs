// The one place that calls into the app's WebAssembly. Texts and bytes are copied at this border.

import { drawText } from './lettering.mjs'

const CURSORS = [
  'default',
  'pointer',
  'move',
  'crosshair',
  'text',
  'ew-resize',
  'ns-resize',
  'nesw-resize',
  'nwse-resize',
]

export class AppBridge {
  #canvas
  #app = null
  #pasted = ''
  #onStatus = () => {}

  constructor(canvas) {
    this.#canvas = canvas
  }

  async create(createApp, wasmBinary) {
    const page = {
      showStatus: (text) => this.#onStatus(text),
      copyText: (text) => navigator.clipboard?.writeText(text).catch(() => {}),
      pasteText: () => this.#pasted,
      drawText,
      setCursor: (cursor) => {
        this.#canvas.style.cursor = CURSORS[cursor] ?? 'default'
      },
    }
    this.#app = await createApp({ canvas: this.#canvas, wasmBinary, page })
  }

  set onStatus(listener) {
    this.#onStatus = listener
  }

  #text(name, types = [], values = []) {
    return this.#app.ccall(name, 'string', types, values)
  }

  #do(name, types = [], values = []) {
    this.#app.ccall(name, null, types, values)
  }

  /** Hands bytes over for the time of one call. */
  #withBytes(bytes, call) {
    const address = this.#app._malloc(Math.max(bytes.length, 1))
    if (!address) throw new Error(`${bytes.length} bytes are more than the browser gives memory for.`)
    this.#app.HEAPU8.set(bytes, address)
    try {
      return call(address, bytes.length)
    } finally {
      this.#app._free(address)
    }
  }

  /** Hands a text over as UTF-8 that ends in 0, on the heap: the stack has no room for long ones. */
  #withText(text, call) {
    return this.#withBytes(new TextEncoder().encode(`${text.replaceAll('\0', '\ufffd')}\0`), call)
  }

  start({ playsAtOnce, dark }) {
    const problem = this.#text('sgStart', ['number', 'number'], [playsAtOnce ? 1 : 0, dark ? 1 : 0])
    if (problem) throw new Error(problem)
  }

  run() {
    this.#do('sgRun')
  }

  setFont(bytes) {
    this.#withBytes(bytes, (address, size) => this.#do('sgSetFont', ['number', 'number'], [address, size]))
  }

  openLibrary(bytes, name) {
    const problem = this.#withBytes(bytes, (address, size) =>
      this.#text('sgOpenLibrary', ['number', 'number'], [address, size]),
    )
    if (problem) throw new Error(`${name}: ${problem}`)
  }
  /** What it is made of, and the notes on its files. */
  library() {
    return JSON.parse(this.#text('sgLibrary'))
  }
  libraryBytes() {
    return this.#file('sgLibraryFile')
  }

  /** Each answers an empty text, or a sentence that says why nothing changed. A scene is the bytes of its file. */
  openScene(bytes, name) {
    return this.#withBytes(bytes, (address, size) =>
      this.#withText(name, (text) =>
        this.#text('sgOpenScene', ['number', 'number', 'number'], [address, size, text]),
      ),
    )
  }
  openLink(fragment) {
    return this.#withText(fragment, (text) => this.#text('sgOpenLink', ['number'], [text]))
  }
  /** What was odd about the scene file that was opened last. */
  sceneNotes() {
    return JSON.parse(this.#text('sgSceneNotes'))
  }

  link() {
    return this.#text('sgLink')
  }
  sceneJson() {
    return this.#text('sgSceneJson')
  }
  pointOf(x, z) {
    return JSON.parse(this.#text('sgPointOf', ['number', 'number'], [x, z]))
  }
  /** Which texts the app can show: whether some are still to be drawn, and those that nobody can draw. */
  lettering() {
    return JSON.parse(this.#text('sgLettering'))
  }
  state() {
    return JSON.parse(this.#text('sgState'))
  }

  #file(name, types = [], values = []) {
    const address = this.#app.ccall(name, 'number', types, values)
    const size = this.#app.ccall('sgFileSize', 'number', [], [])
    return this.#app.HEAPU8.slice(address, address + size)
  }

  /** The bytes of a walker's walk as BVH, counted from 0; empty without a walk. */
  walkBvh(walker) {
    return this.#file('sgWalkBvh', ['number'], [walker])
  }
  /** The bytes of all walks as GLB; empty without any. */
  walksGlb() {
    return this.#file('sgWalksGlb')
  }

  say(text, problem = false) {
    this.#withText(text, (address) => this.#do('sgSay', ['number', 'number'], [address, problem ? 1 : 0]))
  }
  setDark(dark) {
    this.#do('sgSetDark', ['number'], [dark ? 1 : 0])
  }
  resize(width, height, pixelRatio) {
    this.#do('sgResize', ['number', 'number', 'number'], [width, height, pixelRatio])
  }
  pointer(kind, x, y, button, touch, modifiers) {
    this.#app._sgPointer(kind, x, y, button, touch ? 1 : 0, modifiers)
  }
  wheel(x, y, notches, modifiers) {
    this.#app._sgWheel(x, y, notches, modifiers)
  }
  pinch(dragX, dragY, scale, twist) {
    this.#app._sgPinch(dragX, dragY, scale, twist)
  }
  key(key, down, modifiers) {
    this.#app._sgKey(key, down ? 1 : 0, modifiers)
  }
  text(character, modifiers) {
    this.#app._sgText(character, modifiers)
  }
  paste(text) {
    this.#pasted = text
  }
}
