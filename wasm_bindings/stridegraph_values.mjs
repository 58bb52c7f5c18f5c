// What crosses into WebAssembly and back: arguments that are checked, answers that may be refusals, and objects
// that live there. A part of stridegraph.mjs.

/** A refusal: its code is one of Stridegraph.errorCodes; texts are blamed by file, line and column. */
export class StridegraphError extends Error {
  constructor({ code, message, file, line, column }) {
    super(message)
    this.name = 'StridegraphError'
    this.code = code
    this.file = file || undefined
    this.line = line || undefined
    this.column = column || undefined
  }
}

export function unpack(answer) {
  if (answer.error) throw new StridegraphError(answer.error)
  return answer.value
}

/** Deletes what was forgotten; delete() is still the polite way, since nobody knows when this runs. */
const forgotten = new FinalizationRegistry((raw) => raw.delete())

/** An object on the WebAssembly heap, until it is deleted. */
export class Handle {
  #raw
  #module
  #what

  constructor(module, raw, what) {
    this.#module = module
    this.#raw = raw
    this.#what = what
    forgotten.register(this, raw, this)
  }

  get raw() {
    if (!this.#raw) unpack(this.#module.invalidArgument(`the ${this.#what} was deleted, expected one in use`))
    return this.#raw
  }

  delete() {
    if (!this.#raw) return
    forgotten.unregister(this)
    this.#raw.delete()
    this.#raw = undefined
  }
}

function describe(value) {
  if (value === null || value === undefined) return `${value}`
  if (Array.isArray(value)) return 'an array'
  return typeof value === 'object' ? 'an object' : `a ${typeof value}`
}

export function refuse(module, what, found, expected) {
  return unpack(module.invalidArgument(`${what} is ${describe(found)}, expected ${expected}`))
}

export function textOf(module, what, value) {
  return typeof value === 'string' ? value : refuse(module, what, value, 'a string')
}

export function bytesOf(module, what, value) {
  const isBuffer = Object.prototype.toString.call(value) === '[object ArrayBuffer]'
  if (!isBuffer && !ArrayBuffer.isView(value)) {
    return refuse(module, what, value, 'an ArrayBuffer or a typed array of bytes')
  }
  try {
    return isBuffer ? new Uint8Array(value) : new Uint8Array(value.buffer, value.byteOffset, value.byteLength)
  } catch {
    return unpack(module.invalidArgument(`${what} is a buffer that was handed on, expected one in use`))
  }
}

/** A clip as the module takes it: its file as bytes, whatever the encoding, and how to read it if that is given. */
export function clipOf(module, what, clip) {
  const expected = 'an object {name, text} or {name, bytes}'
  if (typeof clip !== 'object' || clip === null) return refuse(module, what, clip, expected)
  const { name, text, bytes, ...reading } = clip
  if (text !== undefined && bytes !== undefined) {
    return unpack(module.invalidArgument(`${what} has both text and bytes, expected one of them`))
  }
  return {
    name: textOf(module, `the name of ${what}`, name),
    bytes:
      bytes === undefined
        ? new TextEncoder().encode(textOf(module, `the text of ${what}`, text))
        : bytesOf(module, `the bytes of ${what}`, bytes),
    reading,
  }
}

/** Escapes of JSON text, in pairs so that an escaped backslash is not taken for the beginning of one. */
const JSON_ESCAPE = /\\(?:ud[89a-f][0-9a-f]{2}|.)/g

export function sceneTextOf(module, scene) {
  if (typeof scene === 'string') return scene
  let text
  try {
    text = JSON.stringify(scene)
  } catch (reason) {
    return unpack(
      module.invalidArgument(`the scene cannot become JSON (${reason.message}), expected a plain object`),
    )
  }
  // JSON.stringify escapes surrogates only where they are lone, which no reader of JSON has to accept.
  const isLone = (escape) => escape.length > 2
  return (
    text?.replace(JSON_ESCAPE, (escape) => (isLone(escape) ? '\ufffd' : escape)) ??
    refuse(module, 'the scene', scene, 'a scene object or its JSON text')
  )
}
