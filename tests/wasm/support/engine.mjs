// The module as it was built, the default library beside it, and rooms to walk in.
import { readFile } from 'node:fs/promises'
import { loadStridegraph, StridegraphError } from '../../../build/wasm/stridegraph.mjs'

export { StridegraphError }
export const root = new URL('../../../', import.meta.url)
export const engine = await loadStridegraph()
export const defaultLibraryBytes = await readFile(new URL('build/library/default.sgraph', root))

/** A room 8 m square with a block in the middle of the way. */
export function smallRoom() {
  return {
    version: 1,
    width: 8,
    depth: 8,
    obstacles: [{ x: 4, z: 4, width: 1, depth: 2 }],
    start: { x: 2, z: 4, heading_deg: 90 },
    goal: { x: 6, z: 4 },
  }
}

/** What a call throws; a StridegraphError, or the test fails. */
export function refusalOf(call) {
  try {
    call()
  } catch (reason) {
    if (reason instanceof StridegraphError) return reason
    throw reason
  }
  throw new Error('nothing was refused')
}
