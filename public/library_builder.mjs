// Builds a library from dropped BVH files in a worker, with progress and a way to stop.

const by = (id) => document.getElementById(id)

/** Resolves when the new library is open, or when the user has cancelled. */
export async function buildLibrary(bridge, files) {
  const clips = await Promise.all(files.map(async (file) => ({ name: file.name, text: await file.text() })))
  const dialog = by('build-dialog')
  const worker = new Worker(new URL('library_worker.mjs', import.meta.url), { type: 'module' })
  by('build-text').textContent =
    `${clips.length === 1 ? 'One clip' : `${clips.length} clips`} to compare and connect.`
  by('build-bar').value = 0
  dialog.showModal()
  try {
    const bytes = await new Promise((resolve, reject) => {
      by('build-cancel').onclick = () => resolve(null)
      dialog.oncancel = () => resolve(null)
      worker.onerror = (event) => reject(new Error(event.message || 'The library could not be built.'))
      worker.onmessage = ({ data }) => {
        if (data.progress !== undefined) by('build-bar').value = data.progress
        if (data.problem) reject(new Error(data.problem))
        if (data.bytes) resolve(data.bytes)
      }
      worker.postMessage({ clips })
    })
    if (!bytes) return
    bridge.openLibrary(bytes)
    bridge.say(`A library of ${clips.length === 1 ? 'one clip' : `${clips.length} clips`} is open now.`)
  } finally {
    worker.terminate()
    dialog.close()
  }
}
