// Says what could not be done, file by file, with all that the reader of the file says.
import { ask, copyFrom, element } from './dialog.mjs'

/** "file:line:column" at the beginning of a message, as the engine writes it. */
const PLACE = /^(.*?:\d+(?::\d+)?): (.*)$/s

function problemItem(message) {
  const [, place, rest] = PLACE.exec(message) ?? [null, '', message]
  const item = element('li', { text: rest })
  if (place) item.prepend(element('b', { text: place }), element('br'))
  return item
}

/**
 * Shows messages, each with its place as the engine writes it, until they are closed. With `goOn`, the label of a way
 * to go on, resolves with whether that was chosen.
 */
export async function tellProblems({ title, sentence, messages, extra, goOn }) {
  const list = element('ul', { className: 'problems' }, ...messages.map(problemItem))
  const body = extra ? element('div', {}, list, extra) : list
  const copy = { label: 'Copy as text', run: (button) => copyFrom(button, messages.join('\n'), list) }
  const close = { label: 'Close', value: '' }
  const actions = goOn ? [copy, close, { label: goOn, value: 'go-on' }] : [copy, close]
  return (await ask({ id: 'problem-dialog', title, sentence, body, actions })) === 'go-on'
}
