// Makes a library from BVH files in a worker: reads them, asks what is doubtful, and connects them, with progress and a
// way to stop.
import { element } from './dialog.mjs'
import { tellProblems } from './problems.mjs'
import { askReadings } from './reading_questions.mjs'

const by = (id) => document.getElementById(id)

const counted = (count, one, many) => (count === 1 ? one : `${count} ${many}`)

/** What a build ends with that has no library. */
class BuildProblem extends Error {
  constructor({ code, message }) {
    super(message)
    this.code = code
  }
}

/** The worker, and the dialog that shows how far it is. */
class Workshop {
  #worker = new Worker(new URL('library_worker.mjs', import.meta.url), { type: 'module' })

  close() {
    this.#worker.terminate()
    by('build-dialog').close()
  }

  /** Resolves with the worker's answer, or with null when the user stops it. */
  async ask(question, sentence, transfer = []) {
    const dialog = by('build-dialog')
    by('build-text').textContent = sentence
    by('build-bar').value = 0
    dialog.showModal()
    try {
      return await new Promise((resolve, reject) => {
        by('build-cancel').onclick = () => resolve(null)
        dialog.oncancel = () => resolve(null)
        this.#worker.onerror = (event) =>
          reject(new BuildProblem({ message: event.message || 'The library could not be built.' }))
        this.#worker.onmessage = ({ data }) => {
          if (data.progress !== undefined) by('build-bar').value = data.progress
          if (data.problem) reject(new BuildProblem(data.problem))
          if (data.answer) resolve(data.answer)
        }
        this.#worker.postMessage(question, transfer)
      })
    } finally {
      dialog.close()
    }
  }
}

/** Those that can be read, if the user wants to go on with them; else null. */
async function readable(inspections) {
  const broken = inspections.filter(({ problem }) => problem)
  const sound = inspections.filter(({ problem }) => !problem)
  if (broken.length === 0) return sound
  const rest = counted(sound.length, 'the other file', 'other files')
  const goesOn = await tellProblems({
    title: `${counted(broken.length, 'One file', 'files')} cannot be read`,
    sentence: 'The library and the scene on screen are as they were.',
    messages: broken.map(({ problem }) => problem),
    goOn: sound.length > 0 ? `Build from ${rest}` : undefined,
  })
  return goesOn ? sound : null
}

/** Fields for what may make clips connect; the engine's advice, where it gives figures, is filled in. */
class RetryFields {
  #threshold
  #mirror

  constructor({ threshold, mirror }, advice) {
    const advised = Number(/threshold of ([0-9.]+) m/.exec(advice)?.[1])
    this.#threshold = element('input', {
      id: 'build-threshold',
      type: 'number',
      min: 0.005,
      max: 1,
      step: 'any',
      required: true,
      value: Number((advised || threshold * 1.5).toPrecision(4)),
    })
    this.#mirror = element('input', {
      id: 'build-mirror',
      type: 'checkbox',
      checked: mirror || /mirror images of the clips/.test(advice),
    })
  }

  get options() {
    return { threshold: this.#threshold.valueAsNumber, mirror: this.#mirror.checked }
  }

  get fields() {
    const field = (text, input) => element('label', { className: 'retry' }, text, input)
    return element(
      'div',
      {},
      field('Threshold, metres per joint', this.#threshold),
      field('Also the clips’ mirror images', this.#mirror),
    )
  }
}

/** Builds; where clips do not connect the user may change what decides it. Null when stopped or given up. */
async function connect(workshop, readings) {
  const sentence = `${counted(readings.length, 'One clip', 'clips')} to compare and connect.`
  for (let options = { threshold: 0.05, mirror: false }; ;) {
    try {
      return await workshop.ask({ readings, options }, sentence)
    } catch (problem) {
      const retry = problem.code === 'empty_graph' ? new RetryFields(options, problem.message) : undefined
      const again = await tellProblems({
        title: 'These clips make no library',
        sentence: 'The library and the scene on screen are as they were.',
        messages: [problem.message],
        extra: retry?.fields,
        goOn: retry && 'Build again',
      })
      if (!again) return null
      options = retry.options
    }
  }
}

/**
 * Builds from clips [{name, bytes}] whose bytes are handed on. Resolves with {bytes, notes, names}, or with null when
 * the user has stopped or been told why there is none.
 */
export async function buildLibrary(clips) {
  const names = clips.map(({ name }) => name)
  const workshop = new Workshop()
  try {
    const buffers = clips.map(({ bytes }) => bytes)
    const reading = `${counted(clips.length, 'One file', 'files')} to read.`
    const inspections = await workshop.ask({ clips }, reading, buffers)
    const sound = inspections && (await readable(inspections))
    const answers = sound && (await askReadings(sound))
    if (!answers) return null
    const readings = sound.map(({ index }) => [index, answers.get(index) ?? {}])
    const built = await connect(workshop, readings)
    return built && { ...built, names: sound.map(({ index }) => names[index]) }
  } finally {
    workshop.close()
  }
}
