// Asks how files are meant whose unit or up axis is a doubtful guess: once for all files with the same doubt.
import { ask, element } from './dialog.mjs'

/** Units that motion files have, in metres. */
const UNITS = [
  { label: 'Centimetres', metres: 0.01 },
  { label: 'Inches', metres: 0.0254 },
  { label: 'Metres', metres: 1 },
  { label: 'Decimetres', metres: 0.1 },
  { label: 'Feet', metres: 0.3048 },
  { label: 'Millimetres', metres: 0.001 },
  { label: 'CMU units of 5.64 cm', metres: 0.0254 / 0.45 },
]
const USUAL_HEIGHT_METRES = 1.7
/** Units that make a body so much larger or smaller than a person are not offered. */
const MOST_ODDNESS = Math.log(6)
const MOST_NAMED = 3
const SHORTEST_METRES = 0.1
const TALLEST_METRES = 100

let questionsAsked = 0

const isSame = (a, b) => Math.abs(a / b - 1) < 0.005

const rounded = (metres) => metres.toFixed(metres < 10 ? 2 : 0)

/** How unlike a person a body of this height is. */
const oddness = (metres) => Math.abs(Math.log(metres / USUAL_HEIGHT_METRES))

/** "1.74 m tall", or from the shortest body to the tallest. */
function heightText(heights) {
  const [low, high] = [Math.min(...heights), Math.max(...heights)].map(rounded)
  return low === high ? `${low} m tall` : `${low} to ${high} m tall`
}

function choice(name, value, isChosen, label, ...details) {
  const input = element('input', { type: 'radio', name, value, checked: isChosen })
  const detail = element('span', { className: 'detail' }, ...details)
  return element('label', { className: 'choice' }, input, element('span', { text: label }), detail)
}

/** The files of one doubt, and the fields that are asked for them. */
class Question {
  #clips
  #upName = `up-${++questionsAsked}`
  #unitName = `unit-${questionsAsked}`
  #fields = element('div', { className: 'question' })
  #details = new Map()
  #own

  constructor(clips) {
    this.#clips = clips
    this.#fields.append(element('h3', { text: this.#filesText() }))
    if (this.#doubts('up_axis')) this.#fields.append(this.#upFields())
    if (this.#doubts('unit')) this.#fields.append(this.#unitFields())
    this.#fields.addEventListener('change', () => this.#showHeights())
    this.#showHeights()
  }

  get fields() {
    return this.#fields
  }

  #doubts(topic) {
    return this.#clips[0].doubts.includes(topic)
  }

  #filesText() {
    const names = this.#clips.map(({ name }) => name)
    const last = names.length > MOST_NAMED ? `${names.length - MOST_NAMED + 1} more files` : names.at(-1)
    const named = names.slice(0, Math.min(names.length, MOST_NAMED) - 1)
    return named.length > 0 ? `${named.join(', ')} and ${last}` : last
  }

  #detail(key) {
    const detail = element('span')
    this.#details.set(key, detail)
    return detail
  }

  #upFields() {
    const choices = ['y', 'z'].map((axis) => {
      const label = axis === 'y' ? 'The y axis' : 'The z axis'
      const isGuess = axis === this.#clips[0].up
      return choice(this.#upName, axis, isGuess, label, this.#detail(axis))
    })
    return element('fieldset', {}, element('legend', { text: 'Which way is up?' }), ...choices)
  }

  #unitFields() {
    const guess = 1 / this.#clips[0].unitsPerMetre
    const [height] = this.#fileHeights()
    const known = UNITS.filter(
      ({ metres }) => !isSame(metres, guess) && oddness(metres * height) < MOST_ODDNESS,
    )
    known.sort((a, b) => oddness(a.metres * height) - oddness(b.metres * height))
    const named = UNITS.find(({ metres }) => isSame(metres, guess))
    const guessed = { label: named?.label ?? `Units of ${rounded(guess * 100)} cm`, metres: guess }
    const choices = [guessed, ...known].map(({ label, metres }, index) =>
      choice(this.#unitName, `${metres}`, index === 0, label, this.#detail(metres)),
    )
    this.#own = element('input', {
      type: 'number',
      min: SHORTEST_METRES,
      max: TALLEST_METRES,
      step: 'any',
      value: USUAL_HEIGHT_METRES,
      ariaLabel: 'Height of the body in metres',
    })
    const own = choice(this.#unitName, 'own', false, 'Another unit', this.#own, ' m tall')
    this.#own.addEventListener('focus', () => (own.querySelector('[type=radio]').checked = true))
    return element(
      'fieldset',
      {},
      element('legend', { text: 'What are the lengths measured in?' }),
      ...choices,
      own,
    )
  }

  #chosen(name) {
    return this.#fields.querySelector(`input[name="${name}"]:checked`)?.value
  }

  /** Heights of the bodies in units of their files, along an axis. */
  #fileHeights(axis) {
    return this.#clips.map(({ up, fileHeights }) => fileHeights[axis ?? up])
  }

  #showHeights() {
    const axis = this.#chosen(this.#upName)
    const unit = Number(this.#chosen(this.#unitName))
    for (const [key, detail] of this.#details) {
      const isAxis = typeof key === 'string'
      const metres = isAxis ? unit || 1 / this.#clips[0].unitsPerMetre : key
      const heights = this.#fileHeights(isAxis ? key : axis).map((height) => height * metres)
      detail.textContent = heightText(heights)
    }
  }

  /** The reading of each file, by the index of its clip. */
  answers() {
    const axis = this.#chosen(this.#upName)
    const unit = this.#chosen(this.#unitName)
    const heights = this.#fileHeights(axis)
    return this.#clips.map(({ index }, at) => {
      const reading = axis ? { up: axis } : {}
      if (unit) reading.units = unit === 'own' ? Number(this.#own.value) / heights[at] : Number(unit)
      return [index, reading]
    })
  }
}

/** Clips with the same doubt and the same guess. */
function groupsOf(clips) {
  const groups = new Map()
  for (const clip of clips) {
    const key = `${clip.doubts} ${clip.up} ${clip.unitsPerMetre.toPrecision(4)}`
    groups.set(key, [...(groups.get(key) ?? []), clip])
  }
  return [...groups.values()]
}

function titleOf(clips) {
  const asks = (topic) => clips.some(({ doubts }) => doubts.includes(topic))
  if (asks('unit') && asks('up_axis')) return 'How tall is the body, and which way is up?'
  return asks('unit') ? 'How tall is the body?' : 'Which way is up?'
}

/**
 * Resolves with a map from the index of a clip to how it is to be read ({units, up}), or with null when the user
 * cancels. `clips` are inspections with their index and `fileHeights`, the body's height along y and z in file units.
 */
export async function askReadings(clips) {
  const doubtful = clips.filter(({ doubts }) => doubts.length > 0)
  if (doubtful.length === 0) return new Map()
  const questions = groupsOf(doubtful).map((group) => new Question(group))
  const answer = await ask({
    id: 'doubt-dialog',
    title: titleOf(doubtful),
    sentence:
      'Motion files do not say this, and here the motion leaves a doubt. The likeliest answer is chosen; beside each is how tall the body would be.',
    body: element('div', {}, ...questions.map(({ fields }) => fields)),
    actions: [{ label: 'Cancel' }, { label: 'Build the library', value: 'build' }],
  })
  return answer && new Map(questions.flatMap((question) => question.answers()))
}
