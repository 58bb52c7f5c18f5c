// Notes about files, for people: grouped by what they are about and by file, with lines.
import { element } from './dialog.mjs'

/** Titles of WarningTopic of stridegraph.d.ts, in the order in which they are shown. */
const TOPICS = {
  unit: 'Unit of lengths',
  up_axis: 'Up axis',
  travel: 'Travel of the body',
  skeleton: 'Joints',
  rows: 'Rows of numbers',
  time: 'Frame times',
  text: 'Text and names',
  motion: 'Motion',
  graph: 'Motion graph',
  scene: 'Members of the scene',
  other: 'Others',
}
/** Topics with more notes are closed at first. */
const MOST_SHOWN = 6

/** Values by a key, keys in the order of their first value. */
function groupBy(values, keyOf) {
  const groups = new Map()
  for (const value of values) {
    const key = keyOf(value)
    groups.set(key, [...(groups.get(key) ?? []), value])
  }
  return groups
}

function byTopic(notes) {
  const groups = groupBy(notes, ({ topic }) => (topic in TOPICS ? topic : 'other'))
  return Object.keys(TOPICS)
    .filter((topic) => groups.has(topic))
    .map((topic) => ({ title: TOPICS[topic], notes: groups.get(topic) }))
}

/** "file:line:column: message", the parts that are known. */
export function describeNote({ file, line, column, message }) {
  const place = [file, line, column].filter((part) => part).join(':')
  return place ? `${place}: ${message}` : message
}

/** All notes as plain text, a line for each. */
export function notesText(notes) {
  return byTopic(notes)
    .map(({ title, notes: some }) => [title, ...some.map((note) => `  ${describeNote(note)}`)].join('\n'))
    .join('\n\n')
}

function fileNotes(file, notes) {
  const entries = notes.map(({ line, message }) => {
    const entry = element('li', { text: message })
    if (line > 0) entry.prepend(element('span', { className: 'place', text: `line ${line}` }), ' ')
    return entry
  })
  const list = element('ul', {}, ...entries)
  return file ? [element('h4', { text: file }), list] : [list]
}

/** A list of notes to be read. */
export function notesList(notes) {
  const topics = byTopic(notes).map(({ title, notes: some }) => {
    const count = element('span', { className: 'count', text: `${some.length}` })
    const summary = element('summary', {}, title, ' ', count)
    const files = [...groupBy(some, ({ file }) => file ?? '')]
    const parts = files.flatMap(([file, ofFile]) => fileNotes(file, ofFile))
    return element('details', { open: some.length <= MOST_SHOWN }, summary, ...parts)
  })
  return element('div', { className: 'notes' }, ...topics)
}
