import { defineConfig } from '@playwright/test';

// Two checkouts can be tested side by side on ports of their own.
const port = Number(process.env['PLATEAU_TEST_PORT'] ?? 4188);

/** The built page in Debian's Chromium, under the policy that scripts/serve.mjs sends. */
export default defineConfig({
  testDir: 'tests',
  testMatch: ['web/**/*.spec.ts', 'parity/**/*.spec.ts'],
  outputDir: 'test-results',
  // Software rendering takes a whole core.
  workers: 1,
  forbidOnly: true,
  timeout: 90_000,
  expect: { timeout: 30_000 },
  reporter: 'list',
  use: {
    baseURL: `http://127.0.0.1:${port}`,
    browserName: 'chromium',
    headless: true,
    viewport: { width: 760, height: 560 },
    acceptDownloads: true,
    // Each test would keep the whole page for a later visit; the tests of that visit allow it.
    serviceWorkers: 'block',
    launchOptions: {
      executablePath: '/usr/bin/chromium',
      args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
    },
  },
  webServer: {
    command: `node scripts/serve.mjs --port ${port}`,
    url: `http://127.0.0.1:${port}`,
    reuseExistingServer: false,
  },
});
