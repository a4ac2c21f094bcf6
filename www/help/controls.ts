/** The names of the controls that the help mentions: arguments of its texts. */

import type { strings } from '../strings/strings.ts';

export const controlNames = (from: typeof strings) => ({
  ...from,
  bookAdd: from.book.add,
  bookSpreadAlbum: from.book.spreadAlbum,
  brushCorrect: from.brush.correct,
  brushFound: from.brush.found,
  cargoKindPhotos: from.cargoKind.photos,
  filmSoundsHear: from.filmSounds.hear,
  partLayout: from.part.layout,
  partPhotos: from.part.photos,
  partStyle: from.part.style,
  sideTabWords: from.sideTab.words,
});
