/**
 * The fonts of the page as fonts of the browser, for the field in which text is written. Their bytes are loaded with the
 * first field, because the policy of the site lets style sheets load no fonts.
 */

import bangers from '../../fonts/Bangers-Regular.ttf?url';
import bold from '../../fonts/ComicNeue-Bold.ttf?url';
import regular from '../../fonts/ComicNeue-Regular.ttf?url';

const FILES: Record<string, string> = { bangers, 'comic-neue': regular, 'comic-neue-bold': bold };
const loading: Map<string, Promise<unknown>> = new Map();

export const fontFamily = (font: string) => `'inkpanel-${font}', 'Comic Neue', 'Comic Sans MS', cursive, sans-serif`;

/** Resolves when the browser has the font with this id. Without a connection, a font of the system is used. */
export function loadFont(font: string): Promise<unknown> {
  const known = loading.get(font);
  if (known) return known;
  const file = FILES[font];
  const load = async () => {
    if (!file) return;
    const bytes = await (await fetch(file)).arrayBuffer();
    document.fonts.add(await new FontFace(`inkpanel-${font}`, bytes).load());
  };
  const made = load().catch(() => loading.delete(font));
  loading.set(font, made);
  return made;
}
