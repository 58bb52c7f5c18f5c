import assert from 'node:assert/strict'
import { describe, it } from 'node:test'
import { fileStem } from '../../public/file_names.mjs'

describe('names of files', () => {
  it('keep letters and digits of every script, in small letters', () => {
    assert.equal(fileStem('Narrow Gap 2', 'scene'), 'narrow_gap_2')
    assert.equal(fileStem('Лабиринт 迷路', 'scene'), 'лабиринт_迷路')
    assert.equal(fileStem('غرفة كبيرة', 'scene'), 'غرفة_كبيرة')
    assert.equal(fileStem('कमरा', 'scene'), 'कमरा')
    assert.equal(fileStem('Raum 🚶‍♀️', 'scene'), 'raum_🚶‍♀️')
  })

  it('compose what was decomposed', () => {
    assert.equal(fileStem('Mu\u0308nchen', 'scene'), 'm\u00fcnchen')
  })

  it('hold nothing that file systems forbid', () => {
    assert.equal(fileStem('a/b\\c:d*e?f"g<h>i|j\nk\u0000l', 'scene'), 'a_b_c_d_e_f_g_h_i_j_k_l')
    assert.equal(fileStem('../../etc/passwd', 'scene'), 'etc_passwd')
    assert.equal(fileStem('evil\u202Egpj', 'scene'), 'evil_gpj')
    assert.equal(fileStem('Con', 'scene'), 'con_')
  })

  it('are never empty and never longer than a file system takes', () => {
    for (const title of ['', '???', '  ', '\ud800', '\u200d']) assert.equal(fileStem(title, 'scene'), 'scene')
    for (const letter of ['a', 'я', '迷', '𠮷', '🚶']) {
      assert.ok(Buffer.byteLength(fileStem(letter.repeat(500), 'scene')) <= 240)
    }
  })
})
