// Lint rules for the page, the scripts and the tests; formatting is prettier's.
import tseslint from 'typescript-eslint';

const typed = ['web/**/*.ts', 'tests/**/*.ts'];
const runtime = [
  ...['process', 'console', 'URL', 'fetch', 'setTimeout', 'clearTimeout', 'Buffer', 'performance'],
  ...['AbortSignal', 'TextDecoder', 'TextEncoder'],
];

export default tseslint.config(
  { ignores: ['build/', 'node_modules/', 'web/dist/', 'test-results/', 'playwright-report/'] },
  ...tseslint.configs.recommended,
  {
    files: typed,
    extends: [...tseslint.configs.recommendedTypeCheckedOnly],
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    rules: {
      '@typescript-eslint/switch-exhaustiveness-check': 'error',
      '@typescript-eslint/consistent-type-imports': 'error',
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
    },
  },
  {
    files: ['web/src/**/*.ts'],
    ignores: ['**/*.d.ts'],
    rules: {
      'no-console': 'error',
      'no-restricted-syntax': [
        'error',
        { selector: 'ExportDefaultDeclaration', message: 'Name what you export.' },
        { selector: 'TSEnumDeclaration', message: 'Use a union of strings.' },
      ],
    },
  },
  {
    files: ['**/*.mjs'],
    languageOptions: { globals: Object.fromEntries(runtime.map((name) => [name, 'readonly'])) },
    rules: { 'no-undef': 'error' },
  },
);
