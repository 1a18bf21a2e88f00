// For typedoc: what is written beside the members of a union becomes a list under it; the Markdown theme leaves it out.
import { Comment, Converter, ReflectionKind } from 'typedoc';

const text = (words) => ({ kind: 'text', text: words });

export function load(app) {
  app.converter.on(Converter.EVENT_RESOLVE_END, ({ project }) => {
    for (const alias of project.getReflectionsByKind(ReflectionKind.TypeAlias)) {
      if (alias.type?.type !== 'union' || !alias.type.elementSummaries) continue;
      const { types, elementSummaries } = alias.type;
      const members = types.flatMap((type, i) => [
        text(`\n- \`${type.toString()}\`: `),
        ...(elementSummaries[i] ?? []),
      ]);
      alias.comment ??= new Comment();
      alias.comment.summary.push(text('\n'), ...members);
    }
  });
}
