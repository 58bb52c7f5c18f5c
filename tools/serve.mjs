// Serves a folder on this machine alone: node tools/serve.mjs FOLDER [--port N]. Port 0 takes any free one.
import { createReadStream } from 'node:fs'
import { realpath, stat } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname, join, resolve, sep } from 'node:path'
import { pathToFileURL } from 'node:url'
import { parseArgs } from 'node:util'

const mimeTypes = {
  '.bvh': 'text/plain; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.glb': 'model/gltf-binary',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.sgraph': 'application/octet-stream',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
}

class Refusal extends Error {
  constructor(status, message) {
    super(message)
    this.status = status
  }
}

/** The file that a request means, its links followed; nothing outside the folder. */
async function findFile(folder, requestUrl) {
  let path
  try {
    path = decodeURIComponent(new URL(requestUrl, 'http://localhost').pathname)
  } catch {
    throw new Refusal(400, 'the address cannot be read')
  }
  if (path.includes('\0')) throw new Refusal(400, 'the address cannot be read')
  const wanted = join(folder, path.endsWith('/') ? `${path}index.html` : path)
  const file = await realpath(wanted).catch(() => undefined)
  if (!file) throw new Refusal(404, `there is no ${path}`)
  if (!file.startsWith(folder + sep)) throw new Refusal(403, 'that lies outside the folder')
  const found = await stat(file)
  if (!found.isFile()) throw new Refusal(404, `${path} is not a file`)
  const tag = `"${found.size.toString(16)}-${Math.floor(found.mtimeMs).toString(16)}"`
  return { file, size: found.size, tag }
}

async function answer(folder, request, response) {
  if (request.method !== 'GET' && request.method !== 'HEAD') throw new Refusal(405, 'only GET and HEAD')
  const { file, size, tag } = await findFile(folder, request.url)
  response.setHeader('Cache-Control', 'no-cache')
  response.setHeader('ETag', tag)
  response.setHeader('X-Content-Type-Options', 'nosniff')
  if (request.headers['if-none-match'] === tag) {
    response.writeHead(304).end()
    return
  }
  const type = mimeTypes[extname(file).toLowerCase()] ?? 'application/octet-stream'
  response.writeHead(200, { 'Content-Type': type, 'Content-Length': size })
  if (request.method === 'HEAD') {
    response.end()
    return
  }
  createReadStream(file)
    .on('error', () => response.destroy())
    .pipe(response)
}

/** Serves a folder on 127.0.0.1; resolves to {address, close} once it listens. */
export async function serve(folder, port = 0) {
  const root = await realpath(resolve(folder))
  const server = createServer((request, response) => {
    answer(root, request, response).catch((reason) => {
      const status = reason instanceof Refusal ? reason.status : 500
      response.writeHead(status, { 'Content-Type': 'text/plain; charset=utf-8' }).end(`${reason.message}\n`)
    })
  })
  await new Promise((done, failed) => server.once('error', failed).listen(port, '127.0.0.1', done))
  const close = () =>
    new Promise((done) => {
      server.close(done)
      server.closeAllConnections()
    })
  return { address: `http://localhost:${server.address().port}/`, close }
}

async function main() {
  const { values, positionals } = parseArgs({
    options: { port: { type: 'string', default: '8080' } },
    allowPositionals: true,
  })
  const [folder] = positionals
  try {
    const { address } = await serve(folder, Number(values.port))
    console.log(`Stridegraph is at ${address} until Ctrl-C`)
  } catch (reason) {
    const inUse = reason.code === 'EADDRINUSE'
    console.error(
      inUse ? `port ${values.port} is taken: choose another with --port` : `cannot serve: ${reason.message}`,
    )
    process.exitCode = 1
  }
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) await main()
