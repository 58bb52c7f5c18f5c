/** Sums up several downloads into one share. Sizes that a server does not tell are guessed until they end. */
export class Progress {
  #report
  #downloads = []

  constructor(report) {
    this.#report = report
  }

  begin(expectedBytes) {
    const download = { expected: expectedBytes || 1_000_000, received: 0 }
    this.#downloads.push(download)
    return (bytes, done = false) => {
      download.received = bytes
      if (done || bytes > download.expected) download.expected = bytes
      this.#tell()
    }
  }

  #tell() {
    let received = 0
    let expected = 0
    for (const download of this.#downloads) {
      received += download.received
      expected += download.expected
    }
    this.#report(expected > 0 ? received / expected : 0, (received / 1e6).toFixed(1))
  }
}

/** The bytes of a file of this site; an error with a plain sentence when it does not come. */
export async function fetchBytes(address, progress) {
  let response
  try {
    response = await fetch(address)
  } catch {
    throw new Error(`${address} cannot be loaded; is the network down?`)
  }
  if (!response.ok) throw new Error(`${address} cannot be loaded (status ${response.status}).`)
  const tell = progress.begin(Number(response.headers.get('content-length')))
  const chunks = []
  let size = 0
  const reader = response.body.getReader()
  for (;;) {
    const { done, value } = await reader.read()
    if (done) break
    chunks.push(value)
    size += value.length
    tell(size)
  }
  tell(size, true)
  const bytes = new Uint8Array(size)
  let at = 0
  for (const chunk of chunks) {
    bytes.set(chunk, at)
    at += chunk.length
  }
  return bytes
}
