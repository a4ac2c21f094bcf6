/** Parts of the page that come when they are first asked for. */

import { useEffect, useState } from 'preact/hooks';

/** @returns what `load` gives, null until it is there; `failed` hears that it cannot be had */
export function useLoaded<Part>(load: () => Promise<Part>, failed: () => void): Part | null {
  const [part, setPart] = useState(null as { loaded: Part } | null);
  useEffect(() => {
    load().then((loaded) => setPart({ loaded }), failed);
  }, []);
  return part && part.loaded;
}
