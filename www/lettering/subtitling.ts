/**
 * Imports speech. Subtitles belong to the frames of their video, on any page. If no page shows a frame, its subtitles
 * are unplaced. Scripts, and subtitles without a video, are distributed over the panels of all pages in order, up to
 * the capacity of each panel. The rest is unplaced text. Each import is one undo step. Files that come with a video
 * wait until its frames are read.
 */

import { signal } from '@preact/signals';
import { hasRole } from '../engine/file-kinds.ts';
import { readText } from '../engine/text-file.ts';
import { textModule } from '../engine/text-module.ts';
import { strings } from '../strings/strings.ts';
import { importText } from '../ui/encodings.ts';
import type { ImportedText } from '../ui/encodings.ts';
import { explain } from '../ui/explain.ts';
import { importing } from '../ui/importing.ts';
import { MOST } from '../document/limits.ts';
import { isUsed } from '../document/album.ts';
import { sheetsOf } from '../engine/sheets.ts';
import { readingOrder } from '../page/reading-order.ts';
import { UserError } from '../ui/user-error.ts';
import type { Messages } from '../ui/messages.ts';
import type { Store } from '../document/store.ts';
import type { Speech, SubtitleFlaw } from '../engine/speech.ts';
import type { Texts } from '../engine/text-module.ts';
import type { AddedWord, Lettering } from './lettering.ts';
import type { Signal } from '@preact/signals';

export type Subtitling = ReturnType<typeof createSubtitling>;

/** A frame of a film, and the panels of pages. */
type Frame = { id: string; name: string; time: number; shown: boolean };
type Place = { sheet: number; panel: number };
/** Puts text items on pages. Without a result, it reports the changes itself. */
type Put = (words: readonly AddedWord[]) => { shown: number; waiting: number } | null;

/** A line that tells who speaks, as `ANNA: Hello` does. */
const SPEAKER = /^[ \t]*[\p{L}\p{N}][^:：\n]{0,60}[:：][ \t]*\S/mu;
/** Characters at the start of a text in which such a line is looked for. */
const BEGINNING = 64 << 10;

/** @returns the files with speech: subtitles, and texts with speakers */
export async function speechAmong(files: readonly File[]): Promise<File[]> {
  const spoken = await Promise.all(
    files.map(
      async (file) => hasRole(file.name, 'subtitles') || (hasRole(file.name, 'text') && (await isScript(file))),
    ),
  );
  return files.filter((_, index) => spoken[index]);
}

async function isScript(file: File): Promise<boolean> {
  // A file that is longer, or cannot be read, is reported when it is opened.
  const { text } = await readText(file.slice(0, MOST.subtitles)).catch(() => ({ text: '' }));
  return SPEAKER.test(text.slice(0, BEGINNING));
}

export function createSubtitling({
  store,
  lettering,
  messages,
  texts = textModule,
}: {
  store: Store;
  lettering: Pick<Lettering, 'lay' | 'reword' | 'step' | 'ready'>;
  messages: Pick<Messages, 'alert' | 'note' | 'fileFailed'>;
  texts?: () => Promise<Pick<Texts, 'script' | 'subtitles'>>;
}) {
  /** The kind of text item for speech. */
  const kind: Signal<'caption' | 'balloon'> = signal('balloon');
  /** Sounds become effects. */
  const sounds = signal(false);
  /** The script as it is being written, which outlives the view. */
  const draft = signal('');

  return { kind, sounds, draft, open, put };

  async function open(files: readonly File[]) {
    for (const file of files)
      await importing(messages, file.name, () =>
        importText(file, { store, messages }, (encoding) => take(file, encoding)),
      );
  }

  async function take(file: File, encoding: string, put: Put = lettering.lay): Promise<ImportedText> {
    if (file.size > MOST.subtitles) throw new UserError(strings.subtitleErrors.large);
    const decoded = await readText(file, encoding);
    let texts: readonly string[] = [];
    const noted: Put = (words) => {
      texts = words.map(({ text }) => text);
      return put(words);
    };
    if (hasRole(file.name, 'text')) await lay(decoded.text, noted);
    else await subtitle(file.name, decoded.text, noted);
    return { decoded, amend: (other) => take(file, other, (words) => amend(texts, words)) };
  }

  /** Replaces the texts of an import that the user has not edited, as one step. */
  function amend(before: readonly string[], words: readonly AddedWord[]): null {
    const gesture = lettering.step();
    // In most encodings, the same number of texts is found.
    const alike = words.length === before.length;
    const n = lettering.reword(new Map(before.map((text, i) => [text, alike ? words[i].text : ''])), gesture);
    if (!alike) lettering.lay(words, gesture);
    messages.note(strings.textReplaced({ n }));
    return null;
  }

  /**
   * Lays a script over the panels of all pages.
   * @returns whether anything was put there
   */
  async function put(script: string): Promise<boolean> {
    try {
      return await lay(script);
    } catch (error) {
      messages.alert(strings.scriptFailed({ why: explain(error) }));
      return false;
    }
  }

  async function lay(text: string, put: Put = lettering.lay): Promise<boolean> {
    if (!(await lettering.ready())) return false;
    const panels = panelsInOrder();
    if (panels.length === 0) throw new UserError(strings.scriptNoPage);
    const { script } = await texts();
    const told = script(text, panels.length, { kind: kind.peek(), sounds: sounds.peek() });
    if (told.words.length === 0) throw new UserError(strings.scriptEmpty);
    spread(told, panels, put);
    return true;
  }

  async function subtitle(name: string, text: string, put: Put) {
    if (!(await lettering.ready())) return;
    const frames = framesOf(name);
    const panels = panelsInOrder();
    if (frames.length === 0 && panels.length === 0) throw new UserError(strings.subtitlesNoFrames);
    const taking = { kind: kind.peek(), sounds: sounds.peek() };
    const { subtitles } = await texts();
    const told = subtitles(text, /\.vtt$/i.test(name), frames, panels.length, taking);
    if ('flaw' in told) throw new UserError(sentence(told.flaw));
    const { words, cues, homeless, left, cut, skipped, flaws, unplaced } = told;
    const tell = (what: string) => messages.alert(strings.fileFailed({ name, why: what }));
    if (left > 0) tell(strings.subtitlesLeft({ n: left, of: cues }));
    if (cut > 0) tell(strings.subtitlesCut({ n: cut }));
    if (skipped > 0) tell(strings.subtitlesSkipped({ n: skipped, why: strings.sentences(flaws.map(sentence)) }));
    if (words.length === 0) throw new UserError(strings.subtitlesNoMatch);
    if (frames.length === 0) {
      spread({ words, unplaced }, panels, put);
      return;
    }
    const added = put(words.map((word) => onFrame(word, frames[word.frame as number])));
    if (!added) return;
    if (added.shown + added.waiting === 0) messages.note(strings.fileFailed({ name, why: strings.subtitlesThere }));
    else messages.note(strings.subtitlesLaid({ ...added, homeless }));
  }

  /** Lays speech over panels, and reports how much of it did not fit. */
  function spread({ words, unplaced }: Speech, panels: readonly Place[], put: Put) {
    const added = put(words.map((word) => onPanel(word, panels)));
    if (!added) return;
    const { shown, waiting } = added;
    const total = words.filter(({ place }) => place !== undefined).length + unplaced;
    const left = total - shown - waiting;
    const spread = { shown, total, missing: total - shown, unplaced: waiting, left };
    if (shown === total) messages.note(strings.scriptLaid({ n: shown }));
    else if (left === 0) messages.note(strings.speechSpread(spread));
    else messages.alert(strings.speechSpread(spread));
  }

  /**
   * Returns the used frames of the subtitles' video: the video with the same name, or any video.
   * @param name of the file of subtitles
   */
  function framesOf(name: string): Frame[] {
    const stem = (file: string) => file.replace(/(\.[a-z]{2,3}(-\w{2,4})?)?\.\w+$/i, '').toLowerCase();
    const videos = store.videos.peek();
    const own = [...videos.values()].filter((video) => stem(video.name) === stem(name)).map(({ key }) => key);
    const album = store.album.peek();
    const verdicts = store.verdicts.peek();
    const shown = new Set(store.sheets.peek().flatMap((page) => page.panels.map(({ photo }) => photo)));
    const all = store.tray.peek().flatMap((item) => {
      const fact = album.get(item.id);
      if (fact?.video === undefined || fact.time === undefined) return [];
      if (!shown.has(item.id) && !isUsed(item, verdicts)) return [];
      const film = videos.get(fact.video)?.name ?? '';
      return [{ id: item.id, name: film, time: fact.time, shown: shown.has(item.id), video: fact.video }];
    });
    const matching = all.filter(({ video }) => own.includes(video));
    return matching.length > 0 ? matching : all;
  }

  /** The panels of all pages, in the order in which they are read; of merged ones the first. */
  function panelsInOrder(): Place[] {
    return sheetsOf(store.project.peek()).flatMap(({ page, sheet }) =>
      readingOrder(page, store.planner.peek()).map((panel) => ({ sheet, panel })),
    );
  }
}

/** Returns a word on its panel, or an unplaced word. */
function onPanel({ frame: _, place, ...word }: Speech['words'][number], panels: readonly Place[]): AddedWord {
  return place === undefined ? word : { ...word, ...panels[place] };
}

/** A film is known by its name: its key is another each time that a project is opened. */
function onFrame({ frame: _, place: __, ...word }: Speech['words'][number], { id, name }: Frame): AddedWord {
  return { ...word, photo: id, panel: 0, cue: `${name} ${word.cue}` };
}

function sentence(flaw: SubtitleFlaw): string {
  const says = strings.subtitleErrors;
  switch (flaw.kind) {
    case 'stray':
    case 'time':
      return says[flaw.kind]({ line: flaw.line, text: flaw.text });
    case 'order':
      return says.order({ line: flaw.line });
    default:
      return says[flaw.kind];
  }
}
