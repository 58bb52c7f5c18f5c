// The one place that calls into the app's WebAssembly. Texts and bytes are copied at this border.

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
    const address = this.#app._malloc(bytes.length)
    this.#app.HEAPU8.set(bytes, address)
    try {
      return call(address, bytes.length)
    } finally {
      this.#app._free(address)
    }
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

  openLibrary(bytes) {
    const problem = this.#withBytes(bytes, (address, size) =>
      this.#text('sgOpenLibrary', ['number', 'number'], [address, size]),
    )
    if (problem) throw new Error(problem)
  }

  /** Each answers an empty text, or a sentence that says why nothing changed. */
  openScene(text, name) {
    return this.#text('sgOpenScene', ['string', 'string'], [text, name])
  }
  openLink(fragment) {
    return this.#text('sgOpenLink', ['string'], [fragment])
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
    this.#do('sgSay', ['string', 'number'], [text, problem ? 1 : 0])
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
