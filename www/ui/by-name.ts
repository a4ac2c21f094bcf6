/** Lists of named items. */

/** Files in natural order: `photo2` before `photo10`. */
export function byName<T extends { name: string }>(files: readonly T[]): T[] {
  const { compare } = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });
  return [...files].sort((a, b) => compare(a.name, b.name));
}
