// Dialogs that are made when they are needed: a title, a sentence, something to read or to fill in, and what to do.

export function element(tag, { text, ...members } = {}, ...children) {
  const made = document.createElement(tag)
  if (text !== undefined) made.textContent = text
  Object.assign(made, members)
  made.append(...children)
  return made
}

/** Copies a text, and says so on the button that asked for it; without a clipboard it marks what can be copied. */
export async function copyFrom(button, text, shown) {
  const label = button.textContent
  try {
    await navigator.clipboard.writeText(text)
    button.textContent = 'Copied'
  } catch {
    getSelection().selectAllChildren(shown)
    button.textContent = 'Marked to copy'
  }
  setTimeout(() => (button.textContent = label), 2000)
}

/** The last action is the one that Enter takes; a form that lacks something keeps it back. */
function actionButton({ label, value = '', run }, isLast, close) {
  if (isLast) return element('button', { text: label, type: 'submit', className: 'primary', value })
  const button = element('button', { text: label, type: 'button' })
  button.addEventListener('click', () => (run ? run(button) : close(value)))
  return button
}

/**
 * Shows a dialog and resolves with the value of the action that was chosen, or null when it was closed by Escape or by
 * an action without a value. An action with `run` keeps the dialog open. `body` scrolls when it is long.
 */
export function ask({ id, title, sentence, body, actions }) {
  const dialog = element('dialog', { id, className: 'report' })
  const heading = element('h2', { id: `${id}-title`, text: title })
  const last = actions.length - 1
  const buttons = actions.map((action, index) =>
    actionButton(action, index === last, (value) => dialog.close(value)),
  )
  const parts = [heading]
  if (sentence) parts.push(element('p', { text: sentence }))
  if (body) parts.push(element('div', { className: 'scroll' }, body))
  parts.push(element('div', { className: 'row' }, ...buttons))
  dialog.append(element('form', { method: 'dialog' }, ...parts))
  dialog.setAttribute('aria-labelledby', heading.id)
  const focus = body?.querySelector('input:checked') ?? buttons[last]
  focus.autofocus = true
  document.querySelector('main').append(dialog)
  dialog.showModal()
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => {
      dialog.remove()
      resolve(dialog.returnValue || null)
    })
  })
}
