/** Lists of named items. */

/** Created with the first use. */
let collator: Intl.Collator | undefined;

/** Files in natural order: `photo2` before `photo10`. */
export function byName<T extends { name: string }>(files: readonly T[]): T[] {
  collator ??= new Intl.Collator('en', { numeric: true, sensitivity: 'base' });
  const { compare } = collator;
  return [...files].sort((a, b) => compare(a.name, b.name));
}
