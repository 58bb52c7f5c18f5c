// Opens the built page in real Chromium, and drives it as a person does: pointer, keys and menus.
import { existsSync, mkdirSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'
import { serve } from '../../tools/serve.mjs'

const root = new URL('../../', import.meta.url)
const site = fileURLToPath(new URL('build/site/', root))
const screenshots = fileURLToPath(new URL('build/screenshots/', root))

// WebGL 2 by software, and nothing that calls out.
const flags = [
  '--no-sandbox',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
]
const patience = 60_000
const interval = 50

export async function startBrowser() {
  if (!existsSync(`${site}index.html`)) throw new Error('build/site is missing: ./run build makes it')
  mkdirSync(screenshots, { recursive: true })
  const server = await serve(site, 0)
  const browser = await chromium.launch({
    executablePath: process.env.STRIDEGRAPH_CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    args: flags,
  })
  const stop = async () => {
    await browser.close()
    await server.close()
  }
  return { address: server.address, browser, stop }
}

/** A visit to the page. Collects whatever is logged as an error. */
export class Visit {
  static async start({ browser, address }, { fragment = '', prepare, ...options } = {}) {
    const context = await browser.newContext({
      viewport: { width: 1280, height: 800 },
      reducedMotion: 'reduce',
      serviceWorkers: 'block',
      permissions: ['clipboard-read', 'clipboard-write'],
      ...options,
    })
    const visit = new Visit(context, await context.newPage())
    await prepare?.(visit.page)
    await visit.page.goto(address + fragment)
    return visit
  }

  constructor(context, page) {
    this.context = context
    this.page = page
    this.canvas = page.locator('#view')
    this.errors = []
    page.on('console', (message) => {
      if (message.type() === 'error') this.errors.push(message.text())
    })
    page.on('pageerror', (problem) => this.errors.push(problem.message))
  }

  end() {
    return this.context.close()
  }

  state() {
    return this.page.evaluate(() => globalThis.stridegraphApp.state())
  }

  /** Waits until the app's state satisfies a predicate; returns the state. */
  async until(predicate) {
    const isReady = () => globalThis.stridegraphApp !== undefined
    await this.page.waitForFunction(isReady, null, { timeout: patience })
    for (let left = patience / interval; left > 0; --left) {
      const state = await this.state()
      if (predicate(state)) return state
      await this.page.waitForTimeout(interval)
    }
    throw new Error(`waited in vain for ${predicate}; the state is ${JSON.stringify(await this.state())}`)
  }

  /** Waits until a walk is planned for what is on screen. */
  untilPlanned() {
    return this.until((state) => state.plan !== null && !state.planning)
  }

  async openSample(file) {
    const before = await this.untilPlanned()
    await this.page.selectOption('#samples', file)
    await this.until((state) => state.plans > before.plans && !state.planning)
    return this.untilSettled()
  }

  /** Waits until the camera rests, so that places on screen stay where they are. */
  untilSettled() {
    return this.until((state) => !state.camera_moving)
  }

  /** Chooses a camera by its key, and waits until it is there. */
  async useCamera(key, name) {
    await this.press(key)
    await this.until((state) => state.camera === name)
    return this.untilSettled()
  }

  async press(key) {
    await this.canvas.press(key)
  }

  /** Waits until the app has drawn what was done so far. */
  framesPass() {
    return this.page.evaluate(async () => {
      for (let left = 2; left > 0; --left) await new Promise((drawn) => requestAnimationFrame(drawn))
    })
  }

  /** Plays until a time of the walk, and pauses there. */
  async playUntil(seconds) {
    await this.press('Space')
    await this.until((state) => state.playing)
    await this.until((state) => state.seconds > seconds)
    await this.press('Space')
    return this.until((state) => !state.playing)
  }

  /** Where a floor point is on the canvas, CSS pixels. */
  pointOf(x, z) {
    return this.page.evaluate(([atX, atZ]) => globalThis.stridegraphApp.pointOf(atX, atZ), [x, z])
  }

  /** Drags with the left button from one floor point to another. */
  dragFloor(from, to) {
    return this.dragFloorHolding(from, to, () => {})
  }

  /** Like dragFloor, with something to do before the button is let go. */
  async dragFloorHolding(from, to, whileHeld) {
    const box = await this.canvas.boundingBox()
    const a = await this.pointOf(...from)
    const b = await this.pointOf(...to)
    await this.page.mouse.move(box.x + a.x, box.y + a.y)
    await this.page.mouse.down()
    await this.page.mouse.move(box.x + (a.x + b.x) / 2, box.y + (a.y + b.y) / 2, { steps: 4 })
    await this.page.mouse.move(box.x + b.x, box.y + b.y, { steps: 4 })
    await whileHeld()
    await this.page.mouse.up()
  }

  /** Waits until every text on the view is drawn; returns those that nobody can draw. */
  async untilLettered() {
    await this.framesPass()
    await this.page.waitForFunction(() => !globalThis.stridegraphApp.lettering().waiting)
    await this.framesPass()
    return this.page.evaluate(() => globalThis.stridegraphApp.lettering().missing)
  }

  /** The scene's name as it is drawn, as PNG. */
  async pictureOfName() {
    const box = await this.canvas.boundingBox()
    return this.page.screenshot({ clip: { x: box.x + 20, y: box.y + 72, width: 220, height: 30 } })
  }

  /** Drops files [{name, bytes}] on the view, as a person does from a folder. */
  async drop(files) {
    const plain = files.map(({ name, bytes }) => ({ name, base64: Buffer.from(bytes).toString('base64') }))
    const dataTransfer = await this.page.evaluateHandle((wanted) => {
      const transfer = new DataTransfer()
      for (const { name, base64 } of wanted) {
        const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))
        transfer.items.add(new File([bytes], name))
      }
      return transfer
    }, plain)
    await this.page.dispatchEvent('#view', 'drop', { dataTransfer })
  }

  /** Waits for a dialog by its id; returns its text. */
  async dialogText(id) {
    await this.page.waitForSelector(`#${id}[open]`, { timeout: patience })
    return this.page.locator(`#${id}`).innerText()
  }

  /** Presses a button of a dialog, and waits until the dialog is gone. */
  async answer(id, label) {
    await this.page.locator(`#${id}`).getByRole('button', { name: label, exact: true }).click()
    await this.page.waitForSelector(`#${id}`, { state: 'detached', timeout: patience })
  }

  /** The bytes of what a button of the page gives away, and its name. */
  async download(selector) {
    const [given] = await Promise.all([this.page.waitForEvent('download'), this.page.click(selector)])
    const chunks = []
    for await (const chunk of await given.createReadStream()) chunks.push(chunk)
    return { name: given.suggestedFilename(), bytes: Buffer.concat(chunks) }
  }

  async screenshot(name) {
    await this.page.screenshot({ path: `${screenshots}${name}.png` })
  }
}
