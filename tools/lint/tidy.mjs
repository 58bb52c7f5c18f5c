// Runs clang-tidy on sources, several at a time, but on none again that was found clean and has not changed since:
// node tidy.mjs BUILD_TREE FOLDER_OF_RESULTS FILE...
//
// A file is unchanged while its compiler command, the settings, clang-tidy and all that it includes are: of the
// project's own headers the content counts, of others size and time.
import { execFile, execFileSync, spawnSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs'
import { availableParallelism, cpus } from 'node:os'
import { join, relative, resolve } from 'node:path'
import { promisify } from 'node:util'

const run = promisify(execFile)
const jobs = availableParallelism?.() ?? cpus().length
const lots = { maxBuffer: 1 << 28 }

const hashOf = (text) => createHash('sha256').update(text).digest('hex')

/** The entries of the build tree's compile_commands.json for these files, by absolute path. */
function commandsFor(tree, files) {
  const wanted = new Set(files.map((file) => resolve(file)))
  const entries = JSON.parse(readFileSync(join(tree, 'compile_commands.json'), 'utf8'))
  return new Map(entries.filter((entry) => wanted.has(entry.file)).map((entry) => [entry.file, entry]))
}

/** Without the caching launcher, which is no compiler. */
const withoutLauncher = (entry) => ({ ...entry, command: entry.command.replace(/^\S*ccache /, '') })

/** The name of clang-scan-deps here: Debian's package has it with the version alone. */
function scanner() {
  const found = ['clang-scan-deps', 'clang-scan-deps-14'].find(
    (name) => spawnSync(name, ['--help']).error === undefined,
  )
  if (found === undefined) {
    throw new Error('clang-scan-deps is not installed. On Debian: apt-get install clang-tools')
  }
  return found
}

/** All that each file includes, and the file, by absolute path. */
async function dependenciesOf(commands, folder) {
  const database = join(folder, 'scanned_commands.json')
  writeFileSync(database, JSON.stringify([...commands.values()].map(withoutLauncher)))
  const { stdout } = await run(scanner(), [`-compilation-database=${database}`, `-j=${jobs}`], lots)
  const dependencies = new Map()
  for (const rule of stdout.replaceAll('\\\n', ' ').split('\n')) {
    const paths = rule.split(/\s+/).filter(Boolean).slice(1)
    if (paths.length > 0) {
      dependencies.set(
        resolve(paths[0]),
        paths.map((path) => resolve(path)),
      )
    }
  }
  return dependencies
}

/** What a file's state is known by, kept for those that are asked for again and again. */
function makeStamp(root) {
  const stamps = new Map()
  return (path) => {
    if (!stamps.has(path)) {
      const isOurs = path.startsWith(`${root}/`)
      const { size, mtimeMs } = statSync(path)
      stamps.set(path, isOurs ? hashOf(readFileSync(path)) : `${size} ${mtimeMs}`)
    }
    return stamps.get(path)
  }
}

/** Runs `work` on each item, so many at a time. */
async function inParallel(items, work) {
  const left = [...items]
  const worker = async () => {
    for (let item = left.shift(); item !== undefined; item = left.shift()) await work(item)
  }
  await Promise.all(Array.from({ length: jobs }, worker))
}

/** The text that clang-tidy says on a file; empty when it finds nothing. */
async function findingsIn(tree, file) {
  try {
    await run('clang-tidy', ['--quiet', '-p', tree, '--warnings-as-errors=*', file], lots)
    return ''
  } catch (failure) {
    return failure.stdout || failure.message
  }
}

async function main(tree, folder, files) {
  mkdirSync(folder, { recursive: true })
  const root = process.cwd()
  const settings =
    execFileSync('clang-tidy', ['--version'], { encoding: 'utf8' }) + readFileSync('.clang-tidy', 'utf8')
  const commands = commandsFor(tree, files)
  const dependencies = await dependenciesOf(commands, folder)
  const stamp = makeStamp(root)
  const keyOf = (file) => {
    const included = dependencies.get(file) ?? []
    return hashOf(
      [settings, commands.get(file).command, ...included.map((path) => `${path} ${stamp(path)}`)].join('\n'),
    )
  }
  const cleanFile = (file) => join(folder, `${relative(root, file).replaceAll('/', '+')}.clean`)
  const isClean = (file) =>
    dependencies.has(file) &&
    existsSync(cleanFile(file)) &&
    readFileSync(cleanFile(file), 'utf8') === keyOf(file)
  const changed = [...commands.keys()].filter((file) => !isClean(file))
  console.log(`clang-tidy: ${changed.length} of ${commands.size} files are new or changed`)
  let faulty = 0
  await inParallel(changed, async (file) => {
    const findings = await findingsIn(tree, file)
    if (findings === '') return writeFileSync(cleanFile(file), keyOf(file))
    faulty += 1
    console.log(findings)
  })
  if (faulty > 0) console.log(`clang-tidy: found something in ${faulty} files`)
  process.exitCode = faulty > 0 ? 1 : 0
}

const [tree, folder, ...files] = process.argv.slice(2)
await main(tree, folder, files)
