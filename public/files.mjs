// Files that people bring, by dropping or by choosing them: scenes, libraries and motion clips.
import { ask, copyFrom } from './dialog.mjs'
import { fileStem } from './file_names.mjs'
import { buildLibrary } from './library_builder.mjs'
import { notesList, notesText } from './notes_list.mjs'
import { tellProblems } from './problems.mjs'

const by = (id) => document.getElementById(id)

const withoutEnding = (name) => name.replace(/\.[^.]*$/, '')

/** What a file holds, by its ending. */
function kindOf({ name }) {
  return /\.(bvh|sgraph|json)$/i.exec(name)?.[1].toLowerCase() ?? 'other'
}

/** All bytes of a file; an error with a sentence when they do not come, as from a folder. */
async function bytesOf(file) {
  try {
    return new Uint8Array(await file.arrayBuffer())
  } catch (reason) {
    throw new Error(`${file.name}: cannot be read (${reason.message}), expected a file.`)
  }
}

export class FileOpener {
  #bridge
  #library
  #underWay = Promise.resolve()

  constructor(bridge, library) {
    this.#bridge = bridge
    this.#library = library
  }

  /** Opens what was dropped or chosen; ends what is still being asked, told or built for earlier files. */
  open(files) {
    for (const dialog of document.querySelectorAll('dialog.report')) dialog.close()
    by('build-cancel').click()
    this.#underWay = this.#underWay.then(() => this.#openAll(files))
    return this.#underWay
  }

  /** Whatever cannot be opened is told of. */
  async #openAll(files) {
    const problems = []
    const attempt = (work) => work.catch((problem) => problems.push(problem.message))
    const of = (kind) => files.filter((file) => kindOf(file) === kind)
    for (const { name } of of('other')) {
      problems.push(`${name}: found another kind of file, expected one that ends in .json, .sgraph or .bvh`)
    }
    for (const kind of ['sgraph', 'json']) {
      for (const { name } of of(kind).slice(1)) {
        problems.push(`${name}: found a second .${kind} file, expected one`)
      }
    }
    const [libraryFile] = of('sgraph')
    const [scene] = of('json')
    if (libraryFile) await attempt(this.#openLibrary(libraryFile))
    if (of('bvh').length > 0) await attempt(this.#build(of('bvh')))
    if (scene) await attempt(this.#openScene(scene))
    if (problems.length > 0) await this.#tell(problems)
  }

  #tell(messages) {
    const title =
      messages.length === 1 ? 'A file cannot be opened' : `${messages.length} files cannot be opened`
    return tellProblems({ title, sentence: 'What is on screen is as it was.', messages })
  }

  async #openLibrary(file) {
    this.#bridge.openLibrary(await bytesOf(file), file.name)
    this.#library.opened(file.name, withoutEnding(file.name))
    this.#bridge.say(`${file.name} is the library now.`)
  }

  async #build(files) {
    const clips = await Promise.all(
      files.map(async (file) => ({ name: file.name, bytes: (await bytesOf(file)).buffer })),
    )
    const built = await buildLibrary(clips)
    if (!built) return
    this.#bridge.openLibrary(built.bytes, 'the new library')
    const { length } = built.names
    const what = length === 1 ? 'one clip' : `${length} clips`
    this.#library.opened(
      length === 1 ? `Library of ${built.names[0]}` : `Library of ${what}`,
      fileStem(withoutEnding(built.names[0]), 'library'),
    )
    this.#bridge.say(`A library of ${what} is open now.`)
    if (this.#library.hasNotes()) await this.#library.show()
  }

  async #openScene(file) {
    const bytes = await bytesOf(file)
    const problem = this.#bridge.openScene(bytes, file.name)
    if (problem) throw new Error(problem)
    by('samples').selectedIndex = 0
    const notes = this.#bridge.sceneNotes()
    if (notes.length === 0) return
    const list = notesList(notes)
    await ask({
      id: 'notes-dialog',
      title: `Notes on ${file.name}`,
      sentence: 'The scene is open. These parts of the file have no effect as they are:',
      body: list,
      actions: [
        { label: 'Copy notes', run: (button) => copyFrom(button, notesText(notes), list) },
        { label: 'Done' },
      ],
    })
  }
}

/** Opens files from the button and those that are dropped anywhere on the page. */
export function connectFiles(opener) {
  const input = by('file')
  by('open').addEventListener('click', () => input.click())
  input.addEventListener('change', () => {
    opener.open([...input.files])
    input.value = ''
  })
  const main = document.querySelector('main')
  const holdsFiles = (event) => event.dataTransfer?.types.includes('Files')
  addEventListener('dragover', (event) => {
    if (!holdsFiles(event)) return
    event.preventDefault()
    main.classList.add('dropping')
  })
  addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) main.classList.remove('dropping')
  })
  addEventListener('drop', (event) => {
    if (!holdsFiles(event)) return
    event.preventDefault()
    main.classList.remove('dropping')
    opener.open([...event.dataTransfer.files])
  })
}
