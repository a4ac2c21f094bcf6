// @ts-check
/** The words about words. */

/** @typedef {'caption' | 'balloon' | 'effect'} Kind */

export const wordStrings = {
  words: 'Words',
  addWord: { caption: 'Add caption', balloon: 'Add balloon', effect: 'Add sound effect' },
  wordShort: { caption: 'Caption', balloon: 'Balloon', effect: 'Sound' },
  /** What a new word says. */
  wordSample: { caption: 'Meanwhile…', balloon: 'Hello!', effect: 'BAM!' },
  wordKind: { caption: 'Caption', balloon: 'Balloon', effect: 'Sound effect' },
  /** @param {Kind} kind @param {string} text */
  word: (kind, text) => `${wordStrings.wordKind[kind]}: ${text}`,
  wordKeys: 'Enter edits the text, arrows move it, Delete removes it',
  wordText: (/** @type {string} */ name) => `Text of ${name}`,
  wordTail: (/** @type {string} */ name) => `Tail of ${name}`,
  tailKeys: 'Arrows move where it points',
  wordList: 'Words on the page',
  noWords: 'No words yet.',
  shape: 'Shape',
  shapes: { oval: 'Speech', thought: 'Thought', shout: 'Shout', whisper: 'Whisper' },
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
  wordRemoved: (/** @type {string} */ name) => `${name} was removed.`,
  wordsFailed: (/** @type {string} */ why) => `The words could not be drawn: ${why}`,

  // Subtitles
  subtitles: 'Subtitles',
  addSubtitles: 'Add subtitles',
  subtitlesFile: 'Subtitle file',
  subtitlesAs: 'As',
  subtitlesKinds: { caption: 'Captions', balloon: 'Balloons' },
  subtitlesAdded: (/** @type {number} */ n) => (n === 1 ? '1 subtitle was put on the page.' : `${n} subtitles were put on the page.`),
  subtitlesNoFrames: 'there is no frame of a video on the page. Add the video first, then its subtitles.',
  subtitlesNoMatch: 'nothing is said at the times of the frames on the page.',
  subtitleErrors: {
    empty: 'there are no subtitles in it.',
    binary: 'it is not text in UTF-8 or UTF-16.',
    large: 'it is larger than 5 MB.',
    time: (/** @type {number} */ line, /** @type {string} */ text) => `line ${line}: “${text}” is not a time like 00:01:02,500 --> 00:01:04,000.`,
    order: (/** @type {number} */ line) => `line ${line}: the subtitle ends before it starts.`,
    header: 'it does not begin with WEBVTT.',
    stray: (/** @type {number} */ line, /** @type {string} */ text) => `line ${line}: a time was expected, not “${text}”.`,
  },
};
