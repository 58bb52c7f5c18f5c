// What people bring: files at fault, files that leave a doubt, and notes that stay with a library.
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { after, afterEach, before, beforeEach, describe, it } from 'node:test'
import { Visit, startBrowser } from './page_driver.mjs'

const folder = new URL('../data/cases/', import.meta.url)
const caseFile = async (name) => ({ name, bytes: await readFile(new URL(name, folder)) })
const broken = (name) => ({ name, bytes: Buffer.from('HIERARCHY\nROOT hip\n') })

/** The sound clip with all lengths so many times as long: 0.45 leaves open whether they are inches or centimetres. */
async function scaledClip(name, factor) {
  const text = (await caseFile('straight.bvh')).bytes.toString()
  const scaled = (numbers) => numbers.map((number) => (Number(number) * factor).toFixed(6))
  const lines = text.split('\n').map((line) => {
    const words = line.trim().split(/\s+/)
    if (words[0] === 'OFFSET') return ['OFFSET', ...scaled(words.slice(1))].join(' ')
    if (words.length < 20) return line
    return [...scaled(words.slice(0, 3)), ...words.slice(3)].join(' ')
  })
  return { name, bytes: Buffer.from(lines.join('\n')) }
}

let server
before(async () => {
  server = await startBrowser()
})
after(() => server?.stop())

let visit
beforeEach(async () => {
  visit = await Visit.start(server)
  await visit.untilPlanned()
})
afterEach(async () => {
  const { errors } = visit
  await visit.end()
  assert.deepEqual(errors, [])
})

const untilOtherLibrary = (hash) => visit.until((state) => state.library_hash !== hash && state.plan !== null)

describe('files at fault', () => {
  it('are all named, and the others may become a library', async () => {
    const first = await visit.state()
    await visit.drop([broken('a.bvh'), await caseFile('straight.bvh'), broken('b.bvh')])
    const text = await visit.dialogText('problem-dialog')
    assert.match(text, /2 files cannot be read/)
    assert.match(text, /a\.bvh:\d+:\d+\s+found/)
    assert.match(text, /b\.bvh:\d+:\d+\s+found/)
    await visit.screenshot('problems')
    await visit.answer('problem-dialog', 'Build from the other file')
    await untilOtherLibrary(first.library_hash)
    const { clips } = await visit.page.evaluate(() => globalThis.stridegraphApp.library())
    assert.deepEqual(
      clips.map(({ name }) => name),
      ['straight.bvh'],
    )
  })

  it('of another kind are named with what is expected', async () => {
    await visit.drop([{ name: 'readme.txt', bytes: Buffer.from('hello') }])
    const text = await visit.dialogText('problem-dialog')
    assert.match(text, /readme\.txt/)
    assert.match(text, /expected one that ends in \.json, \.sgraph or \.bvh/)
    await visit.answer('problem-dialog', 'Close')
  })

  it('are a library that is none', async () => {
    const { library_hash: hash } = await visit.state()
    await visit.drop([{ name: 'none.sgraph', bytes: Buffer.from('nothing') }])
    assert.match(await visit.dialogText('problem-dialog'), /none\.sgraph/)
    await visit.answer('problem-dialog', 'Close')
    assert.equal((await visit.state()).library_hash, hash)
  })

  it('are clips of different bodies, of which each is named', async () => {
    const longer = await scaledClip('longer.bvh', 1.3)
    await visit.drop([await caseFile('straight.bvh'), longer])
    const text = await visit.dialogText('problem-dialog')
    assert.match(text, /straight\.bvh/)
    assert.match(text, /longer\.bvh/)
    await visit.screenshot('problem_of_skeletons')
    await visit.answer('problem-dialog', 'Close')
  })
})

describe('clips whose unit is in doubt', () => {
  const drop = async () =>
    visit.drop([await scaledClip('small.bvh', 0.45), await scaledClip('small_again.bvh', 0.45)])

  it('are asked about once, with the guess chosen, and read as is answered', async () => {
    const first = await visit.state()
    await drop()
    const text = await visit.dialogText('doubt-dialog')
    assert.match(text, /small\.bvh and small_again\.bvh/)
    const radios = visit.page.locator('#doubt-dialog input[type=radio]')
    assert.ok((await radios.count()) >= 3)
    assert.equal(await radios.first().isChecked(), true)
    await visit.screenshot('doubt')
    await visit.page.setViewportSize({ width: 390, height: 844 })
    await visit.screenshot('doubt_phone')
    await visit.page.setViewportSize({ width: 1280, height: 800 })
    await visit.page.keyboard.press('ArrowDown')
    assert.equal(await radios.nth(1).isChecked(), true)
    await visit.page.getByLabel('Centimetres').check()
    await visit.answer('doubt-dialog', 'Build the library')
    const { root } = await untilOtherLibrary(first.library_hash)
    assert.ok(root[1] < 0.6, `the hips are ${root[1]} m above the floor`)
    const { notes } = await visit.page.evaluate(() => globalThis.stridegraphApp.library())
    assert.ok(notes.every(({ message }) => !message.includes('doubtful')))
  })

  it('are read by the height of the body, when that is what is known', async () => {
    const first = await visit.state()
    await drop()
    await visit.dialogText('doubt-dialog')
    await visit.page.locator('#doubt-dialog input[type=number]').fill('1.2')
    await visit.answer('doubt-dialog', 'Build the library')
    const { root } = await untilOtherLibrary(first.library_hash)
    assert.ok(root[1] > 0.5 && root[1] < 0.8, `the hips are ${root[1]} m above the floor`)
  })

  it('are left alone on Escape', async () => {
    const first = await visit.state()
    await drop()
    await visit.dialogText('doubt-dialog')
    await visit.page.keyboard.press('Escape')
    await visit.page.waitForSelector('#doubt-dialog', { state: 'detached' })
    assert.equal((await visit.state()).library_hash, first.library_hash)
    await drop()
    await visit.dialogText('doubt-dialog')
    await visit.answer('doubt-dialog', 'Cancel')
  })
})

describe('notes on files', () => {
  it('are shown with their lines, copied as text, and stay with the saved library', async () => {
    const first = await visit.state()
    await visit.drop([await caseFile('one_frame_more.bvh')])
    const shown = await visit.dialogText('library-dialog')
    assert.match(shown, /Rows of numbers/)
    assert.match(shown, /one_frame_more\.bvh/)
    assert.match(shown, /line \d+/)
    await visit.screenshot('library_notes')
    await visit.page.setViewportSize({ width: 390, height: 844 })
    await visit.screenshot('library_notes_phone')
    await visit.page.setViewportSize({ width: 1280, height: 800 })
    await visit.page.locator('#library-dialog').getByRole('button', { name: 'Copy notes' }).click()
    const copied = await visit.page.evaluate(() => navigator.clipboard.readText())
    assert.match(copied, /one_frame_more\.bvh:\d+:?\d*: /)
    const saved = await visit.download('#library-dialog button:has-text("Save library")')
    assert.equal(saved.name, 'one_frame_more.sgraph')
    await visit.answer('library-dialog', 'Done')
    const built = await visit.state()
    assert.notEqual(built.library_hash, first.library_hash)

    await visit.page.reload()
    await visit.untilPlanned()
    await visit.drop([saved])
    await visit.until((state) => state.library_hash === built.library_hash)
    const { notes } = await visit.page.evaluate(() => globalThis.stridegraphApp.library())
    assert.equal(await visit.page.locator('#library-count').textContent(), `${notes.length}`)
    await visit.page.click('#library')
    assert.match(await visit.dialogText('library-dialog'), /line \d+/)
    await visit.answer('library-dialog', 'Done')
  })

  it('are none where all is well, which is said too', async () => {
    await visit.page.click('#library')
    const text = await visit.dialogText('library-dialog')
    assert.match(text, /The default library/)
    assert.match(text, /\d+ clips/)
    await visit.screenshot('library')
    await visit.answer('library-dialog', 'Done')
  })
})
