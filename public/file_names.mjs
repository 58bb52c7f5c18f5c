// Names for files that are handed to people.

/** Names that Windows keeps for devices, whatever their ending. */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)$/
/** File systems take 255 bytes; a code point has at most four in UTF-8. */
const LONGEST = 60

/**
 * A title as the beginning of a file name: small letters of any script, digits and pictures stay, all else, also what
 * file systems forbid, becomes one underscore.
 */
export function fileStem(title, otherwise) {
  const kept = title
    .normalize('NFC')
    .toLowerCase()
    .replace(/[^\p{L}\p{M}\p{N}\p{So}\p{Sk}\u200c\u200d]+/gu, '_')
  const short = [...kept].slice(0, LONGEST).join('')
  const stem = short.replace(/^[_\u200c\u200d]+|[_\u200c\u200d]+$/g, '')
  if (!stem) return otherwise
  return RESERVED.test(stem) ? `${stem}_` : stem
}
