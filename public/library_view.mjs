// The library that is open: what it is made of, what was odd about its files, and how to keep it.
import { ask, copyFrom, element } from './dialog.mjs'
import { download } from './downloads.mjs'
import { notesList, notesText } from './notes_list.mjs'

const by = (id) => document.getElementById(id)

const counted = (count, one, many) => `${count.toLocaleString('en')} ${count === 1 ? one : many}`

function duration(seconds) {
  const whole = Math.round(seconds)
  return whole < 60 ? `${seconds.toFixed(1)} s` : `${Math.floor(whole / 60)} min ${whole % 60} s`
}

function summary({ clips, frames, fps, transitions }) {
  const captured = clips.filter(({ mirrored }) => !mirrored).length
  const mirrored = clips.length > captured ? ', each also mirrored' : ''
  return (
    `${counted(captured, 'clip', 'clips')}${mirrored}: ${duration(frames / fps)} of motion at ${fps} frames a second, ` +
    `${counted(transitions, 'transition', 'transitions')}.`
  )
}

function clipsList({ clips, fps }) {
  const items = clips.map(({ name, frames, mirrored }) => {
    const length = element('span', { className: 'detail', text: duration(frames / fps) })
    return element('li', {}, element('span', { text: mirrored ? `${name}, mirrored` : name }), length)
  })
  const count = element('span', { className: 'count', text: `${clips.length}` })
  return element(
    'details',
    { className: 'clips' },
    element('summary', {}, 'Clips ', count),
    element('ul', {}, ...items),
  )
}

export class LibraryView {
  #bridge
  #title = 'The default library'
  #stem = 'default'

  constructor(bridge) {
    this.#bridge = bridge
    by('library').addEventListener('click', () => this.show())
    this.#showCount()
  }

  /** Tells of a library that was opened just now. */
  opened(title, stem) {
    this.#title = title
    this.#stem = stem
    this.#showCount()
  }

  hasNotes() {
    return this.#bridge.library().notes.length > 0
  }

  #showCount() {
    const { length } = this.#bridge.library().notes
    by('library-count').textContent = length > 0 ? `${length}` : ''
    by('library').title = length > 0 ? `The library, with ${counted(length, 'note', 'notes')}` : 'The library'
  }

  /** Resolves when the dialog is closed. */
  show() {
    const library = this.#bridge.library()
    const { notes, license } = library
    const heading = `${notes.length === 0 ? 'No notes' : counted(notes.length, 'note', 'notes')} on its files and its graph`
    const list = notesList(notes)
    const body = element('div', {}, element('h3', { text: heading }), list, clipsList(library))
    if (license) body.append(element('p', { className: 'license', text: license }))
    const copy = { label: 'Copy notes', run: (button) => copyFrom(button, notesText(notes), list) }
    const save = { label: 'Save library', run: () => this.#save() }
    const actions = [...(notes.length > 0 ? [copy] : []), save, { label: 'Done' }]
    return ask({ id: 'library-dialog', title: this.#title, sentence: summary(library), body, actions })
  }

  #save() {
    download(this.#bridge.libraryBytes(), `${this.#stem}.sgraph`, 'application/octet-stream')
  }
}
