/**
 * Reads screenplays in Fountain format (https://fountain.io/syntax): scenes, action and dialogue. It reads the text
 * once from start to end, so the time is linear.
 */

/** A paragraph of a screenplay with its scene and dialogue. */
export type ScriptLine = { scene: string; action?: string; dialogue?: string };

const TITLE = /^(?:title|credit|authors?|source|notes|draft ?date|date|contact|copyright|revisions?):/i;
const HEADING = /^(?:int|ext|est|int\.?\/ext|ext\.?\/int|i\.?\/e)[. ]/i;
/** A period before a text makes it a heading; several are an ellipsis. */
const FORCED_HEADING = /^\.(?=[^\s.])/;
const SCENE_NUMBER = /#([\w.-]{1,20})#$/;
const TRANSITION = /(?:\bTO:|^FADE IN[.:]?|^FADE OUT[.:]?|^(?:FADE|CUT) TO BLACK[.:]?)$/;
/** Takes the place of a removed comment, so that a line with only a comment is not an empty line. */
const REMOVED = '\0';

/** Whether a text begins with a title page or has a scene heading. */
export function isFountain(text: string): boolean {
  return TITLE.test(text.trimStart()) || text.split(/[\r\n]+/).some((line) => HEADING.test(line.trimStart()));
}

/**
 * Reads the paragraphs of a screenplay, one per shot. Dialogue belongs to the preceding action. A scene without
 * paragraphs gives its synopses, or without synopses its heading, so outlines work too.
 */
export function fountainLines(text: string): ScriptLine[] {
  const lines: ScriptLine[] = [];
  /** Synopses of sections, for outlines without scenes. */
  const sketched: ScriptLine[] = [];
  let scene = '';
  /** The scene or section since the last heading. */
  let part = { name: '', isScene: false, filled: false, synopses: [] as string[] };
  /** Whether the next dialogue belongs to the last line. */
  let open = false;

  for (const block of blocksOf(text)) {
    let at = 0;
    while (at < block.length && isStructure(block[at])) at += 1;
    addParagraph(block.slice(at));
  }
  endPart();
  return lines.length > 0 ? lines : sketched;

  /** Takes a heading, section, synopsis or page break. */
  function isStructure(line: string): boolean {
    const heading = headingOf(line);
    if (heading !== null) {
      endPart();
      scene = heading;
      open = false;
      part = { name: scene, isScene: true, filled: false, synopses: [] };
    } else if (line.startsWith('#')) {
      endPart();
      part = { name: plain(line.replace(/^#+/, '').trim()), isScene: false, filled: false, synopses: [] };
    } else if (/^=(?!=)/.test(line)) part.synopses.push(plain(line.slice(1).trim()));
    else return /^={3,}$/.test(line);
    return true;
  }

  function endPart() {
    const { name, isScene, filled, synopses } = part;
    if (filled) return;
    const beats = synopses.filter(Boolean).map((action) => ({ scene: name, action }));
    if (!isScene) sketched.push(...beats);
    else lines.push(...(beats.length > 0 ? beats : [{ scene: name }]));
  }

  function addParagraph(paragraph: readonly string[]) {
    const [first, ...rest] = paragraph;
    if (first === undefined) return;
    const speaker = rest.length > 0 ? speakerOf(first) : null;
    if (speaker !== null) addSpeech(speaker, rest);
    else if (paragraph.every(isLyric)) say('', joined(paragraph.map(withoutMark)));
    else if (rest.length > 0 || !isTransition(first)) act(joined(paragraph.map(withoutForce)));
  }

  /** Adds the dialogue of a character. A parenthetical or a song splits it into parts. */
  function addSpeech(speaker: string, rest: readonly string[]) {
    let said: string[] = [];
    let sung = false;
    for (const line of rest) {
      const aside = line.startsWith('(') && line.endsWith(')');
      if (aside || isLyric(line) !== sung) {
        say(speaker, joined(said));
        said = [];
      }
      sung = isLyric(line);
      if (!aside) said.push(sung ? withoutMark(line) : line);
    }
    say(speaker, joined(said));
  }

  function say(speaker: string, text: string) {
    if (text === '') return;
    const dialogue = speaker ? `${speaker}: ${text}` : text;
    const last = lines.at(-1);
    if (open && last) last.dialogue = last.dialogue === undefined ? dialogue : `${last.dialogue}\n${dialogue}`;
    else lines.push({ scene, dialogue });
    part.filled = true;
    open = true;
  }

  function act(action: string) {
    if (action === '') return;
    lines.push({ scene, action });
    part.filled = true;
    open = true;
  }
}

/** Paragraphs without the title page, comments and notes, as trimmed lines. */
function blocksOf(text: string): string[][] {
  const blocks: string[][] = [];
  let block: string[] = [];
  const lines = without(text, '/*', '*/').split(/\r\n|\r|\n/);
  for (const line of [...lines, '']) {
    if (line.trim() !== '') block.push(line.trim());
    // In dialogue, a line of two spaces does not end the paragraph.
    else if (block.length > 0 && !(line === '  ' && block.length > 1 && speakerOf(block[0]) !== null)) {
      blocks.push(block);
      block = [];
    }
  }
  if (TITLE.test(blocks[0]?.[0] ?? '')) blocks.shift();
  return blocks.map((lines) =>
    without(lines.join('\n'), '[[', ']]')
      .split('\n')
      .flatMap((line) => line.replaceAll(REMOVED, '').trim() || []),
  );
}

/** Removes comments of one kind. */
function without(text: string, start: string, end: string): string {
  const kept: string[] = [];
  let from = 0;
  for (;;) {
    const at = text.indexOf(start, from);
    const close = at < 0 ? -1 : text.indexOf(end, at + start.length);
    if (close < 0) return kept.join('') + text.slice(from);
    kept.push(text.slice(from, at), REMOVED);
    from = close + end.length;
  }
}

/** Returns a scene heading with its number in front, or null for another line. */
function headingOf(line: string): string | null {
  const bare = line.replace(/^[*_]+/, '');
  if (!FORCED_HEADING.test(bare) && !HEADING.test(bare)) return null;
  const heading = plain(line).replace(FORCED_HEADING, '');
  const number = SCENE_NUMBER.exec(heading);
  return number ? `${number[1]} ${heading.slice(0, number.index).trim()}` : heading;
}

/** Returns the name of a character with the text in brackets after it, or null for other lines. */
function speakerOf(line: string): string | null {
  // A caret marks dialogue that is spoken at the same time.
  const single = line.endsWith('^') ? line.slice(0, -1).trim() : line;
  if (line.startsWith('@')) return joined([single.slice(1)]);
  const [name] = single.split('(', 1);
  const isName = /\p{L}/u.test(name) && !/\p{Ll}/u.test(name) && !/^[!.>~=#]/.test(name) && !isTransition(name.trim());
  return isName ? joined([single]) : null;
}

function isTransition(line: string): boolean {
  if (line.startsWith('>')) return !line.endsWith('<');
  return TRANSITION.test(line) && !/\p{Ll}/u.test(line);
}

function isLyric(line: string): boolean {
  return line.startsWith('~');
}

function withoutMark(line: string): string {
  return line.slice(1);
}

/** Removes the marks of forced action and of centred text. */
function withoutForce(line: string): string {
  if (line.startsWith('!')) return line.slice(1);
  return line.startsWith('>') && line.endsWith('<') ? line.slice(1, -1) : line;
}

function joined(lines: readonly string[]): string {
  return lines
    .map((line) => plain(line.trim()))
    .join(' ')
    .replace(/\s+/g, ' ')
    .trim();
}

/** A cased letter or a digit: marks between them are part of a name or a calculation. */
const WORD = /[\p{Lu}\p{Ll}\p{Lt}\p{N}]/u;
const KINDS: readonly string[] = ['*', '**', '***', '_'];

/** Removes the marks of emphasis and the backslashes of escaped characters. */
function plain(line: string): string {
  const removed = new Set<number>();
  /** Positions of opening marks without a closing mark, by kind. */
  const opened = new Map<string, number>();
  const remove = (at: number, count: number) => {
    for (let i = at; i < at + count; i += 1) removed.add(i);
  };
  for (const { 0: run, index } of line.matchAll(/\\[@#!*_$~`+=.><\\/]|[*_]+/g)) {
    if (run.startsWith('\\')) {
      remove(index, 1);
      continue;
    }
    const [before, after] = [line[index - 1] ?? ' ', line[index + run.length] ?? ' '];
    const opens = !/\s/.test(after) && !WORD.test(before);
    const closes = !/\s/.test(before) && !WORD.test(after);
    for (const { 0: mark, index: within } of run.matchAll(/\*+|_+/g)) {
      if (!KINDS.includes(mark)) continue;
      const at = index + within;
      const start = opened.get(mark);
      if (closes && start !== undefined) {
        remove(start, mark.length);
        remove(at, mark.length);
        // Marks opened in between remain in the text.
        for (const [kind, place] of opened) if (place >= start) opened.delete(kind);
      } else if (opens) opened.set(mark, at);
    }
  }
  return Array.from({ length: line.length }, (_, i) => (removed.has(i) ? '' : line[i])).join('');
}
