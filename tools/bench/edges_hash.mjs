const prime = 0x100000001b3n

/** A hash of a plan's edges, the same as in the runs that `stridegraph bench` writes: FNV-1a of 64 bits. */
export function edgesHash(edges) {
  if (edges.length === 0) return ''
  let hash = 0xcbf29ce484222325n
  for (const byte of Buffer.from(edges.map(([from, to]) => `${from}-${to},`).join(''))) {
    hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * prime)
  }
  return hash.toString(16).padStart(16, '0')
}
