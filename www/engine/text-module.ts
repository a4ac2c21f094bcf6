/** The wasm module of text files: encodings, subtitles and scripts. Loaded with the first of them. */

import { moduleBytes } from './module-bytes.ts';
import { onceMore } from './once-more.ts';
import type { ReadSubtitles, Speech, Taking } from './speech.ts';

const MODULE = new URL('../pkg-texts/inkpanel_bg.wasm', import.meta.url);

export type Texts = Awaited<ReturnType<typeof open>>;

/** Loads the module. Rejects with `texts-missing`; the next call tries again. */
export const { get: textModule } = onceMore(open);

async function open() {
  const bytes = await moduleBytes(MODULE, 'texts-missing', 'The reader of text files could not be loaded.');
  const {
    default: init,
    decode,
    encodings,
    middles,
    names,
    script,
    subtitles,
  } = await import('../pkg-texts/inkpanel.js');
  await init({ module_or_path: bytes });
  return {
    decode,
    encodings,
    names,
    /** @returns the middle of each subtitle in seconds */
    middles,
    /**
     * @param vtt whether the file must begin as WebVTT does
     * @param frames their times in seconds, and whether a page shows them; without frames, text items are placed on
     *   `panels` in order
     */
    subtitles: (
      text: string,
      vtt: boolean,
      frames: readonly { time: number; shown: boolean }[],
      panels: number,
      { kind, sounds }: Taking,
    ): ReadSubtitles => {
      const places = Float64Array.from(frames.flatMap(({ time, shown }) => [time, Number(shown)]));
      return JSON.parse(subtitles(text, vtt, places, panels, kind, sounds));
    },
    /** @returns a script placed on panels in order, and its number of lines */
    script: (text: string, panels: number, { kind, sounds }: Taking): Speech & { lines: number } =>
      JSON.parse(script(text, panels, kind, sounds)),
  };
}
