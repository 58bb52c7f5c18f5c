// What a newer program would write: libraries and links of a version that this one does not know.

/** The library with the version in its first table raised; the hash no longer holds, which nobody may look at. */
export function newerLibrary(bytes) {
  const copy = Uint8Array.from(bytes)
  const view = new DataView(copy.buffer)
  const table = view.getUint32(0, true)
  const vtable = table - view.getInt32(table, true)
  const version = table + view.getUint16(vtable + 4, true)
  view.setUint32(version, view.getUint32(version, true) + 1, true)
  return copy
}

/** FNV-1a of 64 bits, folded to 32. */
function checksum(bytes) {
  let hash = 0xcbf29ce484222325n
  for (const byte of bytes) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n)
  return Number((hash ^ (hash >> 32n)) & 0xffffffffn)
}

/** The link with the greatest version there can be and a checksum that holds. */
export function newerLink(link) {
  const bytes = Buffer.from(link.slice('s='.length), 'base64url')
  bytes[0] = 255
  const body = bytes.subarray(0, bytes.length - 4)
  bytes.writeUInt32LE(checksum(body), body.length)
  return `s=${bytes.toString('base64url')}`
}
