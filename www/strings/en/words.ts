/** The words about words. */

export type Kind = 'caption' | 'balloon' | 'effect';

export const wordStrings = {
  words: 'Text',
  addWord: { caption: 'Add caption', balloon: 'Add balloon', effect: 'Add sound effect' },
  wordShort: { caption: 'Caption', balloon: 'Balloon', effect: 'Sound' },
  /** What a new word says. */
  wordSample: { caption: 'Meanwhile…', balloon: 'Hello!', effect: 'BAM!' },
  wordKind: { caption: 'Caption', balloon: 'Balloon', effect: 'Sound effect' },
  word: (kind: Kind, text: string) => `${wordStrings.wordKind[kind]}: ${text}`,
  wordKeys: 'Enter edits the text, arrows move it, Delete removes it',
  wordText: (name: string) => `Text of ${name}`,
  wordTail: (name: string) => `Tail of ${name}`,
  tailKeys: 'Arrows move where it points',
  wordList: 'Words on the page',
  noWords: 'No words yet.',
  shape: 'Shape',
  shapes: { oval: 'Speech', thought: 'Thought', shout: 'Shout', whisper: 'Whisper', radio: 'Radio' },
  editWord: 'Edit text',
  moveWord: 'Move to…',
  pointTail: 'Point tail at…',
  removeTail: 'Remove tail',
  placeWord: 'Place by itself',
  removeWord: 'Remove word',
  wordX: 'Across',
  wordY: 'Down',
  wordWidth: 'Width',
  wordSize: 'Letter size',
  wordAuto: 'fitted',
  wordAngle: 'Angle',
  wordArc: 'Arc',
  wordColor: 'Letters',
  wordFill: 'Fill',
  wordFont: 'Font',
  fonts: { 'comic-neue': 'Comic Neue', 'comic-neue-bold': 'Comic Neue Bold', bangers: 'Bangers' },
  wordCut: 'The text is too long for the page: its end is missing.',
  wordModes: { move: 'Click where it goes', tail: 'Click what it points at' },
  wordRemoved: (name: string) => `${name} was removed.`,
  wordsFull: (most: number) => `A page holds ${most} words. Remove some before you add more.`,
  wordsFailed: (why: string) => `The words could not be drawn: ${why}`,

  // Subtitles
  addSubtitles: 'Add subtitles',
  subtitlesFile: 'Subtitle file',
  subtitlesAs: 'As',
  subtitlesKinds: { caption: 'Captions', balloon: 'Balloons' },
  subtitlesNoFrames: 'there is no page yet. Add photos or the video first.',
  subtitlesNoMatch: 'nothing in it is said near the times of the frames.',
  subtitlesLeft: (n: number, of: number) => `${of} subtitles were read; ${n} more are too many and were left out.`,
  subtitlesCut: (n: number) =>
    n === 1
      ? 'a subtitle is too long, so its end was left out.'
      : `${n} subtitles are too long, so their ends were left out.`,
  subtitleErrors: {
    empty: 'there are no subtitles in it.',
    binary: 'it is no text that can be read.',
    large: 'it is larger than 5 MB.',
    time: (line: number, text: string) => `line ${line}: “${text}” is not a time like 00:01:02,500 --> 00:01:04,000.`,
    order: (line: number) => `line ${line}: the subtitle ends before it starts.`,
    header: 'it does not begin with WEBVTT.',
    stray: (line: number, text: string) => `line ${line}: a time was expected, not “${text}”.`,
  },
};
