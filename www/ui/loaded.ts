/** Parts of the app that are loaded on demand. */

import { useEffect, useState } from 'preact/hooks';

/** @returns the result of `load`, null until then; `failed` is called on an error */
export function useLoaded<Part>(load: () => Promise<Part>, failed: () => void): Part | null {
  const [part, setPart] = useState(null as { loaded: Part } | null);
  useEffect(() => {
    load().then((loaded) => setPart({ loaded }), failed);
  }, []);
  return part && part.loaded;
}
