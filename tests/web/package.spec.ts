// The package in a browser: its ten lines, from another origin, under a policy that allows what the guide says and no more.
import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { ForeignServer } from './foreign-page.ts';

const read = (path: string): string => readFileSync(new URL(`../../${path}`, import.meta.url), 'utf8');
/** What stands between the first fences of a kind. */
const block = (text: string, kind: string): string =>
  new RegExp(`^\`\`\`${kind}\\n([^]*?)^\`\`\`$`, 'm').exec(text)?.[1] ?? '';

test('the ten lines print what the guide says, and the worker ends with the run', async ({
  page,
  baseURL,
}) => {
  const guide = read('docs/package.md');
  const program = `${block(guide, 'js').replace("'plateau'", "'./browser.js'")}console.log('done');\n`;
  const [, printed = ''] = /^It prints\n\n```\n([^]*?)^```$/m.exec(guide) ?? [];
  const cors = { 'Access-Control-Allow-Origin': '*' };
  await page.route('**/package/*', (route) => {
    const name = new URL(route.request().url()).pathname.replace(/^.*\//, '');
    if (name === 'program.js')
      return route.fulfill({ body: program, contentType: 'text/javascript', headers: cors });
    const path = fileURLToPath(new URL(`../../build/package/${name}`, import.meta.url));
    return existsSync(path) ? route.fulfill({ path, headers: cors }) : route.fulfill({ status: 404 });
  });
  const said: string[] = [];
  page.on('console', (message) => said.push(message.text()));
  page.on('pageerror', (error) => said.push(error.message));
  const foreign = await ForeignServer.start(baseURL ?? '');
  try {
    const script = `<script type="module" src="${baseURL}/package/program.js"></script>`;
    await page.goto(foreign.put('/lines', `<!doctype html><title>Ten lines</title>${script}`));
    await expect.poll(() => said.at(-1)).toBe('done');
    expect(`${said.slice(0, -1).join('\n')}\n`).toBe(printed);
    await expect.poll(() => page.workers().length).toBe(0);
  } finally {
    await foreign.stop();
  }
});
