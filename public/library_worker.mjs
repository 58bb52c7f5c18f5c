// Builds a motion library from BVH texts away from the page, with the same module that anybody can import.
import { loadStridegraph } from './stridegraph.mjs'

async function build({ clips }) {
  const engine = await loadStridegraph()
  const onProgress = (progress) => postMessage({ progress })
  const library = await engine.buildLibraryAsync(clips, {}, { onProgress })
  const bytes = library.toBytes()
  postMessage({ bytes, warnings: library.buildReport?.warnings.length ?? 0 }, [bytes.buffer])
}

self.addEventListener('message', ({ data }) => {
  build(data).catch((problem) => {
    const place = [problem.file, problem.line, problem.column].filter((part) => part !== undefined).join(':')
    postMessage({ problem: place ? `${place}: ${problem.message}` : problem.message })
  })
})
