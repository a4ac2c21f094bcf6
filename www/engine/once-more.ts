/** A promise that is made when it is first asked for, and anew after it failed. */
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
