// @ts-check
/**
 * Subtitles of a video onto the page: each goes to the panel whose frame is of its time. Files that come with the video
 * wait until its frames are read.
 */

import { signal } from '@preact/signals';
import { strings } from '../strings.js';
import { cueAt, readSubtitles } from './subtitles.js';

/** @typedef {import('../engine/documents.js').Word} Word */
/** @typedef {import('./subtitles.js').Cue} Cue */
/** @typedef {ReturnType<typeof createSubtitling>} Subtitling */

/** Seconds that a frame may be before or after what is said. */
const SLACK = 0.75;

/**
 * @param {{
 *   store: import('./store.js').Store, lettering: Pick<import('./lettering.js').Lettering, 'addAll'>,
 *   messages: Pick<import('./messages.js').Messages, 'alert' | 'note' | 'fileFailed'>,
 * }} app
 */
export function createSubtitling({ store, lettering, messages }) {
  /** What subtitles become. @type {import('@preact/signals').Signal<'caption' | 'balloon'>} */
  const kind = signal('caption');

  return { kind, open };

  /** @param {readonly File[]} files */
  async function open(files) {
    for (const file of files) {
      try {
        await put(file);
      } catch (error) {
        messages.fileFailed(file.name, /** @type {Error} */ (error).message);
      }
    }
  }

  /** @param {File} file */
  async function put(file) {
    const { cues, left, cut } = await readSubtitles(file);
    if (left > 0) messages.alert(strings.fileFailed(file.name, strings.subtitlesLeft(left, cues.length)));
    if (cut > 0) messages.alert(strings.fileFailed(file.name, strings.subtitlesCut(cut)));
    const frames = framesOf(file.name);
    if (frames.length === 0) throw new Error(strings.subtitlesNoFrames);
    const words = matched(cues, frames, kind.peek());
    if (words.length === 0) throw new Error(strings.subtitlesNoMatch);
    const added = await lettering.addAll(words);
    if (added > 0) messages.note(strings.subtitlesAdded(added));
  }

  /**
   * The panels that show a frame of the video that the subtitles are of: that of the same name, else of any.
   * @param {string} name of the file of subtitles
   */
  function framesOf(name) {
    const stem = (/** @type {string} */ file) => file.replace(/(\.[a-z]{2,3})?\.\w+$/i, '').toLowerCase();
    const videos = [...store.videos.peek().values()];
    const own = videos.filter((video) => stem(video.name) === stem(name)).map(({ key }) => key);
    const album = store.album.peek();
    const page = store.page.peek();
    const all = (page?.panels ?? []).flatMap(({ photo }, panel) => {
      const fact = album.get(photo ?? '');
      const leads = page?.merges.every((group) => !group.includes(panel) || group[0] === panel);
      return fact?.video !== undefined && fact.time !== undefined && leads ? [{ panel, time: fact.time, video: fact.video }] : [];
    });
    const matching = all.filter(({ video }) => own.includes(video));
    return matching.length > 0 ? matching : all;
  }
}

/**
 * Words for the frames at whose times something is said; a subtitle goes to one frame only, the nearest to its middle.
 * @param {readonly Cue[]} cues
 * @param {readonly { panel: number, time: number }[]} frames
 * @param {'caption' | 'balloon'} kind
 * @returns {Word[]}
 */
export function matched(cues, frames, kind) {
  /** @type {Map<Cue, { panel: number, time: number }>} */
  const places = new Map();
  for (const frame of frames) {
    const cue = cueAt(cues, frame.time, SLACK);
    const before = cue && places.get(cue);
    const off = (/** @type {{ time: number }} */ { time }) => Math.abs(time - ((cue?.start ?? 0) + (cue?.end ?? 0)) / 2);
    if (cue && (!before || off(frame) < off(before))) places.set(cue, frame);
  }
  return [...places].map(([{ text }, { panel }]) => ({ kind, text, panel, auto: true }));
}
