// Pointer, touch and key events of the canvas, in CSS pixels from its upper left corner. Keys reach the app
// only while the canvas has the focus; all others stay with the browser.

const MOVE = 0
const PRESS = 1
const RELEASE = 2
const LEAVE = 3

/** Positions as in Key of web/ui/input.h. */
const KEYS = [
  'Tab',
  'ArrowLeft',
  'ArrowRight',
  'ArrowUp',
  'ArrowDown',
  'Home',
  'End',
  'Insert',
  'Delete',
  'Backspace',
  ' ',
  'Enter',
  'Escape',
  'a',
  'b',
  'c',
  'g',
  's',
  'v',
  'x',
  'y',
  'z',
  'f',
  'm',
  'w',
]
/** With Control or Command held, these are the app's; everything else is the browser's. */
const SHORTCUTS = new Set(['z', 'y', 'a', 'c', 'v', 'x'])
const BUTTONS = { 0: 0, 1: 2, 2: 1 }

const modifiersOf = (event) =>
  (event.ctrlKey || event.metaKey ? 1 : 0) | (event.shiftKey ? 2 : 0) | (event.altKey ? 4 : 0)

function followSize(canvas, bridge) {
  const apply = () => {
    const { width, height } = canvas.getBoundingClientRect()
    const ratio = globalThis.devicePixelRatio || 1
    canvas.width = Math.max(1, Math.round(width * ratio))
    canvas.height = Math.max(1, Math.round(height * ratio))
    bridge.resize(canvas.width / ratio, canvas.height / ratio, ratio)
  }
  new ResizeObserver(apply).observe(canvas)
  const watchRatio = () => {
    matchMedia(`(resolution: ${globalThis.devicePixelRatio}dppx)`).addEventListener(
      'change',
      () => {
        apply()
        watchRatio()
      },
      { once: true },
    )
  }
  watchRatio()
  apply()
}

/** Two fingers move the camera; one finger is a pointer like any other. */
class Fingers {
  #at = new Map()

  get several() {
    return this.#at.size > 1
  }
  put(event) {
    this.#at.set(event.pointerId, { x: event.clientX, y: event.clientY })
  }
  drop(event) {
    this.#at.delete(event.pointerId)
  }
  #measure() {
    const [a, b] = [...this.#at.values()]
    const dx = b.x - a.x
    const dy = b.y - a.y
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, reach: Math.hypot(dx, dy), angle: Math.atan2(dy, dx) }
  }
  /** How both fingers together have moved with this event. */
  move(event) {
    const before = this.#measure()
    this.put(event)
    const now = this.#measure()
    const twist = Math.atan2(Math.sin(now.angle - before.angle), Math.cos(now.angle - before.angle))
    return { x: now.x - before.x, y: now.y - before.y, scale: now.reach / Math.max(before.reach, 1), twist }
  }
}

function connectPointer(canvas, bridge) {
  const fingers = new Fingers()
  const pass = (kind, event) => {
    const box = canvas.getBoundingClientRect()
    bridge.pointer(
      kind,
      event.clientX - box.left,
      event.clientY - box.top,
      BUTTONS[event.button] ?? 0,
      event.pointerType === 'touch',
      modifiersOf(event),
    )
  }
  canvas.addEventListener('pointerdown', (event) => {
    canvas.focus({ preventScroll: true })
    canvas.setPointerCapture(event.pointerId)
    if (event.pointerType === 'touch') fingers.put(event)
    if (!fingers.several) pass(PRESS, event)
    event.preventDefault()
  })
  canvas.addEventListener('pointermove', (event) => {
    if (event.pointerType === 'touch' && fingers.several) {
      const moved = fingers.move(event)
      bridge.pinch(moved.x, moved.y, moved.scale, moved.twist)
      return
    }
    if (event.pointerType === 'touch') fingers.put(event)
    pass(MOVE, event)
  })
  const release = (event) => {
    fingers.drop(event)
    if (!fingers.several) pass(RELEASE, event)
  }
  canvas.addEventListener('pointerup', release)
  canvas.addEventListener('pointercancel', release)
  canvas.addEventListener('pointerleave', (event) => pass(LEAVE, event))
  canvas.addEventListener('contextmenu', (event) => event.preventDefault())
  canvas.addEventListener(
    'wheel',
    (event) => {
      const box = canvas.getBoundingClientRect()
      const perNotch = event.deltaMode === WheelEvent.DOM_DELTA_PIXEL ? 100 : 3
      const notches = Math.max(-3, Math.min(3, event.deltaY / perNotch))
      bridge.wheel(event.clientX - box.left, event.clientY - box.top, notches, modifiersOf(event))
      event.preventDefault()
    },
    { passive: false },
  )
}

function connectKeys(canvas, bridge) {
  const held = new Set()
  const indexOf = (event) => KEYS.indexOf(event.key.length === 1 ? event.key.toLowerCase() : event.key)
  const belongsToBrowser = (event) => {
    if (event.key === 'Tab' || event.isComposing) return true
    return (event.ctrlKey || event.metaKey) && !SHORTCUTS.has(event.key.toLowerCase())
  }
  canvas.addEventListener('keydown', (event) => {
    if (belongsToBrowser(event)) return
    const modifiers = modifiersOf(event)
    const index = indexOf(event)
    if (index >= 0) {
      bridge.key(index, true, modifiers)
      held.add(index)
    }
    const isText = [...event.key].length === 1 && !event.ctrlKey && !event.metaKey
    if (isText) bridge.text(event.key.codePointAt(0), modifiers)
    const pastes = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'v'
    if ((index >= 0 || isText) && !pastes) event.preventDefault()
  })
  canvas.addEventListener('keyup', (event) => {
    const index = indexOf(event)
    if (!held.delete(index)) return
    bridge.key(index, false, modifiersOf(event))
  })
  canvas.addEventListener('blur', () => {
    for (const index of held) bridge.key(index, false, 0)
    held.clear()
  })
  addEventListener('paste', (event) => bridge.paste(event.clipboardData?.getData('text/plain') ?? ''), true)
}

export function connectInput(canvas, bridge) {
  followSize(canvas, bridge)
  connectPointer(canvas, bridge)
  connectKeys(canvas, bridge)
}
