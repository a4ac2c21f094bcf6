import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { expect, test } from 'vitest';

const TOP = join(import.meta.dirname, '..');
const isProduct = (file: string) => /\.tsx?$/.test(file) && !/\.test\.|testing/.test(file) && file.includes('/');
const folderOf = (file: string) => file.split('/')[0];

/** The folders that each folder imports, also types. */
function imports(): Map<string, Set<string>> {
  const skipped = /^(node_modules|dist|pkg)/;
  const folders = readdirSync(TOP, { withFileTypes: true }).filter(
    (one) => one.isDirectory() && !skipped.test(one.name),
  );
  const files = folders
    .flatMap(({ name }) =>
      (readdirSync(join(TOP, name), { recursive: true }) as string[]).map((file) => `${name}/${file}`),
    )
    .filter(isProduct);
  const known = new Map<string, Set<string>>();
  for (const file of files) {
    for (const [, target] of readFileSync(join(TOP, file), 'utf8').matchAll(/(?:from|import\() ?'(\.[^']+)'/g)) {
      const to = folderOf(normalize(join(dirname(file), target)));
      if (to !== folderOf(file)) known.set(folderOf(file), (known.get(folderOf(file)) ?? new Set()).add(to));
    }
  }
  return known;
}

test('no folders import each other in a circle, not even types', () => {
  const left = imports();
  expect(left.size).toBeGreaterThan(15);
  for (;;) {
    const free = [...left].filter(([, targets]) => ![...targets].some((target) => left.has(target)));
    if (free.length === 0) break;
    for (const [folder] of free) left.delete(folder);
  }
  expect([...left.keys()]).toEqual([]);
});
