/** A promise that is created on first use, and again after a failure. */
export function onceMore<T>(begin: () => Promise<T>) {
  let begun: Promise<T> | undefined;
  const forget = () => {
    begun = undefined;
  };
  const get = () => {
    begun ??= begin().catch((error) => {
      forget();
      throw error;
    });
    return begun;
  };
  return { get, forget };
}
