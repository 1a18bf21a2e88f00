// In the browser's worker: runs of the module alone, each under several budgets. Nothing of the page is involved.
/* global self, TextEncoder */
import createModule from './plateau.mjs';

const everything = 0xffffffff;

function hashOf(module, source, options, budget) {
  const run = new module.Run(source, options);
  try {
    for (let answer = run.open(budget); answer.kind !== 'opened'; answer = run.open(budget)) {
      if (answer.kind === 'failed') return answer.failure.message;
    }
    for (;;) {
      const answer = run.run(budget, everything);
      if (answer.kind === 'failed') return answer.failure.message;
      if (answer.state === 'finished') return run.hash();
    }
  } finally {
    run.delete();
  }
}

self.onmessage = async ({ data: { cases, budgets } }) => {
  const module = await createModule({ locateFile: (name) => new URL(name, import.meta.url).href });
  self.postMessage(
    cases.map(({ fileName, text, family, options, anyDimension }) =>
      budgets.map((budget) => {
        const bytes = new TextEncoder().encode(text).buffer;
        const source = { kind: 'file', name: fileName, bytes, anyDimension };
        return hashOf(module, source, { family, ...options }, budget);
      }),
    ),
  );
};
