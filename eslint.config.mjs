import js from '@eslint/js'
import globals from 'globals'

export default [
  { ignores: ['build/', '.cache/', 'node_modules/'] },
  js.configs.recommended,
  {
    files: ['**/*.{js,mjs}'],
    languageOptions: { ecmaVersion: 2022, sourceType: 'module', globals: globals.browser },
    rules: {
      curly: ['error', 'multi-line'],
      eqeqeq: 'error',
      'no-shadow': 'error',
      'no-var': 'error',
      'prefer-const': 'error',
    },
  },
  {
    files: ['wasm_bindings/*.mjs', 'tests/**/*.mjs', 'tools/**/*.mjs', 'examples/*.mjs'],
    languageOptions: { globals: { ...globals.nodeBuiltin, ...globals.browser } },
  },
  {
    files: ['public/**/*worker*.{js,mjs}'],
    languageOptions: { globals: { ...globals.worker, ...globals.serviceworker } },
  },
  {
    files: ['wasm_bindings/export_default.js'],
    languageOptions: { globals: { createStridegraphModule: 'readonly' } },
  },
]
