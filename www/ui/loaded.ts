/** Parts of the page that come when they are first asked for. */

import { useEffect, useState } from 'preact/hooks';

/** @returns the result of `load`, null until then; `failed` is called on an error */
export function useLoaded<Part>(load: () => Promise<Part>, failed: () => void): Part | null {
  const [part, setPart] = useState(null as { loaded: Part } | null);
  useEffect(() => {
    load().then((loaded) => setPart({ loaded }), failed);
  }, []);
  return part && part.loaded;
}
