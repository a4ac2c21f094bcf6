/** Strings of lettering tools, scripts and subtitles. */

export const speechStrings = {
  wordResize: 'Resize text',
  resizeKeys: 'Arrow keys make it wider or narrower',
  wordTurn: 'Rotate text',
  turnKeys: 'Arrow keys rotate it by 1 degree; with Shift, by 15',
  wordMissing: (letters: string) => `No font has these characters, so they appear as question marks: ${letters}`,
  wordForeign: 'Some characters use a font of this device.',
  wordSlant: 'Slant',
  wordOutline: 'Outline',
  wordCapitals: 'All caps',
  wordVertical: 'Vertical text',
  wordJoin: 'Link to the previous balloon',
  wordBoxless: 'No box',
  wordBehind: 'Behind the subject',
  wordBehindWhy: 'The text stays in front until the photo has a clear subject mask.',
  wordBar: 'Lettering tools',
  barSmaller: 'Smaller text',
  barLarger: 'Larger text',
  script: 'Script and subtitles',
  scriptText: 'Script or dialogue',
  scriptSample: 'ANNA: Where are we?\nBEN: Nearly there.\n\nSFX: Splash',
  scriptHelp:
    'One line per balloon, starting with NAME: and then the text. An empty line moves to the next panel, and a line such as PANEL 3 to that panel.',
  putScript: 'Create balloons',
  soundsAsEffects: 'Sound cues as sound effects',
  scriptLaid: (n: number) =>
    n === 1 ? '1 text item was added to the pages.' : `${n} text items were added to the pages.`,
  speechSpread: (shown: number, total: number, unplaced: number, left: number) =>
    [
      `${shown} of ${total} lines were placed; ${total - shown} did not fit.`,
      ...(unplaced > 0 ? [`${unplaced} ${unplaced === 1 ? 'is' : 'are'} in the list of unplaced text.`] : []),
      ...(left > 0 ? [`${left} ${left === 1 ? 'was' : 'were'} left out.`] : []),
    ].join(' '),
  scriptNoPage: 'there is no page yet. Add photos first.',
  scriptEmpty: 'it has no dialogue.',
  scriptOffered: (names: string) => `${names} may be a script. It was not added to the pages.`,
  scriptFailed: (why: string) => `The script was not added to the page: ${why}`,
  subtitlesLaid: (shown: number, waiting: number, homeless: number) =>
    [
      shown === 1 ? '1 text item was added to the pages.' : `${shown} text items were added to the pages.`,
      ...(waiting > 0 ? [`${waiting} ${waiting === 1 ? 'is' : 'are'} hidden, because no page shows the frame.`] : []),
      ...(homeless > 0 ? [`${homeless} did not fit in a frame near ${homeless === 1 ? 'its' : 'their'} time.`] : []),
    ].join(' '),
  subtitlesThere: 'all of its subtitles are on the pages.',
  subtitlesSkipped: (n: number, why: readonly string[]) =>
    `${n === 1 ? 'a subtitle was skipped' : `${n} subtitles were skipped`}: ${why.join(' ')}`,
  textGuessed: (encoding: string) => `it is not UTF-8, so its text was read as ${encoding}.`,
  textLost: (n: number) => (n === 1 ? '1 character could not be read.' : `${n} characters could not be read.`),
  changeEncoding: 'Change encoding',
  encodingOf: (name: string) => `Encoding of ${name}`,
  encoding: 'Encoding',
  encodingPreview: 'Preview',
  readAgain: 'Read again',
  wordsWaiting: (n: number) => (n === 1 ? '1 unplaced text' : `${n} unplaced texts`),
  wordsWaitingWhy:
    'Text returns when a page shows its photo again. Text without a photo stays here until you put it on a page.',
  putWaiting: (text: string) => `Add to this page: ${text}`,
  dropWaiting: (text: string) => `Discard: ${text}`,
  dropAllWaiting: 'Discard all',
};
