// Writes the table of docs/fuzzing.md from what ./run fuzz left behind:
// node fuzz_table.mjs FOLDER_OF_FUZZING FOLDER_OF_COVERAGE FILE
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs'

// What each target is about, as the beginnings of paths.
const modules = {
  bvh: ['core/motion/bvh_', 'core/motion/glb_', 'core/base/'],
  library: ['core/graph/'],
  link: ['core/scene/scene_link', 'core/scene/packed_bytes', 'core/scene/base64_url'],
  plan: ['core/walk/', 'core/path/'],
  scene: ['core/scene/json_', 'core/scene/scene_reader', 'core/scene/scene_writer', 'core/scene/scene_check'],
  sgraph: ['core/graph/sgraph_', 'core/graph/library_checks'],
}

const begin = '<!-- table: begin -->'
const end = '<!-- table: end -->'

/** Lines and lines run of the target's own files, headers and sources. */
function coveredLines(json, beginnings) {
  const sum = { count: 0, covered: 0 }
  for (const { filename, summary } of json.data[0].files) {
    if (!beginnings.some((beginning) => filename.includes(`/${beginning}`))) continue
    sum.count += summary.lines.count
    sum.covered += summary.lines.covered
  }
  return sum
}

function shareOf(file, beginnings) {
  if (!existsSync(file)) return 'not measured'
  const lines = coveredLines(JSON.parse(readFileSync(file, 'utf8')), beginnings)
  return `${Math.round((100 * lines.covered) / lines.count)} % of ${lines.count}`
}

function corpusOf(target) {
  const folder = `tests/fuzz/corpus/${target}`
  const files = readdirSync(folder)
  const bytes = files.reduce((sum, file) => sum + statSync(`${folder}/${file}`).size, 0)
  return `${files.length} files, ${Math.ceil(bytes / 1024)} KiB`
}

function row(target, fuzzing, coverage) {
  const results = `${fuzzing}/results/${target}.tsv`
  if (!existsSync(results)) return `| ${target} | not run | | | | | ${corpusOf(target)} |`
  const [seconds, executions, speed, edges, features] = readFileSync(results, 'utf8').trim().split('\t')
  const share = shareOf(`${coverage}/${target}.json`, modules[target])
  return (
    `| ${target} | ${seconds} | ${Number(executions).toLocaleString('en')} | ${speed} ` +
    `| ${edges} / ${features} | ${share} | ${corpusOf(target)} |`
  )
}

const [fuzzing, coverage, file] = process.argv.slice(2)
const table = [
  '| target | seconds | executions | a second | edges / features | lines of its own modules | corpus |',
  '|---|---|---|---|---|---|---|',
  ...Object.keys(modules).map((target) => row(target, fuzzing, coverage)),
].join('\n')
const text = readFileSync(file, 'utf8')
const from = text.indexOf(begin)
const to = text.indexOf(end)
if (from < 0 || to < from) throw new Error(`${file}: found no table, expected ${begin} and ${end}`)
writeFileSync(file, `${text.slice(0, from)}${begin}\n\n${table}\n\n${text.slice(to)}`)
