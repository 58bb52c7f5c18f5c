// Prints what becomes of the thesis's own pair of jogs: nodes and edges before and after pruning for several rules, and
// walks with them. Run from the top folder after ./run build: node tools/thesis_pair.mjs > table.md

import { execFileSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'

const program = 'build/bin/stridegraph'
const thesis = { before: { nodes: 87, edges: 147 }, after: { nodes: 74, edges: 120 } }
const rules = [
  { threshold: 0.03, neighbours: 0, frames: 13 },
  { threshold: 0.033, neighbours: 0, frames: 13 },
  { threshold: 0.036, neighbours: 0, frames: 13 },
  { threshold: 0.04, neighbours: 0, frames: 13 },
  { threshold: 0.06, neighbours: 0, frames: 13 },
  { threshold: 0.036, neighbours: 1, frames: 13 },
  { threshold: 0.06, neighbours: 1, frames: 13 },
  { threshold: 0.06, neighbours: 6, frames: 13 },
  { threshold: 0.024, neighbours: 0, frames: 7 },
]
const rooms = ['one_obstacle', 'labyrinth']

const folder = mkdtempSync(join(tmpdir(), 'thesis-pair-'))
const inFolder = (name) => join(folder, name)

// Runs the program and says what it said, whether it could do it or not.
const run = (...words) => {
  try {
    return execFileSync(program, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] })
  } catch (failure) {
    return failure.stderr
  }
}

const build = ({ threshold, neighbours, frames }) => {
  const clips = ['straight', 'zig_zag'].map((kind) => inFolder(`thesis_pair/thesis_${kind}_jog.bvh`))
  const rule = ['--threshold', threshold, '--neighbours', neighbours, '--transition-frames', frames].map(
    String,
  )
  run('build', ...clips, '-o', inFolder('pair.sgraph'), ...rule, '--report', inFolder('build.json'))
  const report = JSON.parse(readFileSync(inFolder('build.json'), 'utf8'))
  const count = (part) => ({ nodes: part.nodes, edges: part.clip_pieces + part.transitions })
  return {
    before: count(report.before_pruning),
    after: count(report.after_pruning),
    share: `${Math.round(100 * report.surviving_share)} %`,
  }
}

const walk = (room) => {
  const files = ['-o', inFolder('walk.bvh'), '--report', inFolder('walk.json')]
  run(
    'plan',
    '--graph',
    inFolder('pair.sgraph'),
    '--scene',
    `public/scenes/${room}.json`,
    '--goal-radius',
    '0.5',
    ...files,
  )
  const report = JSON.parse(readFileSync(inFolder('walk.json'), 'utf8'))
  return report.status === 'arrived'
    ? `${report.motion_length_m.toFixed(1)} m along ${report.path_length_m.toFixed(1)} m`
    : report.status
}

const row = (cells) => console.log(`| ${cells.join(' | ')} |`)
const pair = ({ nodes, edges }) => `${nodes} / ${edges}`

run('gait', '-o', folder)
row([
  'threshold m',
  'neighbourhood',
  'transition',
  'before pruning',
  'after pruning',
  'frames kept',
  ...rooms,
])
row(['---', '---', '---', '---', '---', '---', ...rooms.map(() => '---')])
row(['thesis', 'not stated', '13', pair(thesis.before), pair(thesis.after), '', ...rooms.map(() => 'walked')])
for (const rule of rules) {
  const { before, after, share } = build(rule)
  row([rule.threshold, rule.neighbours, rule.frames, pair(before), pair(after), share, ...rooms.map(walk)])
}
rmSync(folder, { recursive: true })
