// Reads BVH files and builds a motion library from them away from the page, with the same module that anybody can
// import. First `inspect` with all clips, then `build` with what is to become of each.
import { loadStridegraph } from './stridegraph.mjs'

const engine = loadStridegraph()
let clips = []

/** The body's height along each axis that may be up, in units of the file. */
function fileHeights(sg, clip) {
  const along = (up) => {
    const { heightMetres, unitsPerMetre } = sg.inspectClip(clip, { up })
    return heightMetres * unitsPerMetre
  }
  return { y: along('y'), z: along('z') }
}

function inspected(sg, clip, index) {
  try {
    const { doubts, unitsPerMetre, up } = sg.inspectClip(clip)
    const heights = doubts.length > 0 ? fileHeights(sg, clip) : undefined
    return { index, name: clip.name, doubts, unitsPerMetre, up, fileHeights: heights }
  } catch (problem) {
    return { index, name: clip.name, problem: asMessage(problem) }
  }
}

async function inspect(wanted) {
  const sg = await engine
  clips = wanted
  const answers = []
  for (const [index, clip] of clips.entries()) {
    answers.push(inspected(sg, clip, index))
    postMessage({ progress: (index + 1) / clips.length })
  }
  postMessage({ answer: answers })
}

/** `readings` is a list of [index of a clip, {units, up}]; clips that it does not name are left out. */
async function build(readings, options) {
  const sg = await engine
  const chosen = readings.map(([index, reading]) => ({ ...clips[index], ...reading }))
  const onProgress = (progress) => postMessage({ progress })
  const library = await sg.buildLibraryAsync(chosen, options, { onProgress })
  const bytes = library.toBytes()
  postMessage({ answer: { bytes, notes: library.notes } }, [bytes.buffer])
  library.delete()
}

/** A problem with its place, as the program prints it. */
function asMessage({ code, message, file, line, column }) {
  // Whatever has no code is no refusal but the end of the engine, as a rule for want of memory.
  if (!code) {
    return `The engine stopped (${message}): as a rule the files need more memory than the browser gives.`
  }
  const place = [file, line, column].filter((part) => part !== undefined).join(':')
  return place ? `${place}: ${message}` : message
}

self.addEventListener('message', ({ data }) => {
  const work = data.clips ? inspect(data.clips) : build(data.readings, data.options)
  work.catch((problem) => postMessage({ problem: { code: problem.code, message: asMessage(problem) } }))
})
