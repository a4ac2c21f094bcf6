/** Strings of lettering tools, scripts and subtitles. */

export const speechStrings = {
  wordResize: 'Größe des Textes ändern',
  resizeKeys: 'Pfeile machen es breiter oder schmaler',
  wordTurn: 'Text drehen',
  turnKeys: 'Pfeile drehen um ein Grad, mit Umschalt um 15',
  wordMissing: (letters: string) =>
    `Keine Schrift hat diese Zeichen, daher erscheinen sie als Fragezeichen: ${letters}`,
  wordForeign: 'Einige Zeichen verwenden eine Schrift dieses Geräts.',
  wordSlant: 'Neigung',
  wordOutline: 'Kontur',
  wordCapitals: 'In Großbuchstaben',
  wordVertical: 'Vertikaler Text',
  wordJoin: 'Mit der vorigen Sprechblase verbinden',
  wordBoxless: 'Ohne Kasten',
  wordBehind: 'Hinter dem Motiv',
  wordBehindWhy: 'Der Text steht davor, bis das Foto eine deutliche Motivmaske hat.',
  wordBar: 'Schriftwerkzeuge',
  barSmaller: 'Kleinere Schrift',
  barLarger: 'Größere Schrift',
  script: 'Skript und Untertitel',
  scriptText: 'Skript oder Dialog',
  scriptSample: 'ANNA: Wo sind wir?\nBEN: Gleich da.\n\nSFX: Platsch',
  scriptHelp:
    'Eine Zeile je Sprechblase, vorn NAME:. Eine leere Zeile geht zum nächsten Panel, eine Zeile wie PANEL 3 zu diesem Panel.',
  putScript: 'Sprechblasen erstellen',
  soundsAsEffects: 'Geräusche als Soundwörter',
  scriptLaid: (n: number) =>
    n === 1 ? '1 Text wurde auf die Seiten gesetzt.' : `${n} Texte wurden auf die Seiten gesetzt.`,
  speechSpread: (shown: number, total: number, unplaced: number, left: number) =>
    [
      `${shown} von ${total} Zeilen wurden gesetzt; ${total - shown} passten nicht.`,
      ...(unplaced > 0
        ? [`${unplaced} ${unplaced === 1 ? 'steht' : 'stehen'} in der Liste nicht platzierter Texte.`]
        : []),
      ...(left > 0 ? [`${left} ${left === 1 ? 'wurde' : 'wurden'} ausgelassen.`] : []),
    ].join(' '),
  scriptNoPage: 'Es gibt noch keine Seite. Füge erst Fotos hinzu.',
  scriptEmpty: 'Es enthält keinen Dialog.',
  scriptOffered: (names: string) => `${names} könnte ein Skript sein. Der Text wurde nicht auf die Seiten gesetzt.`,
  scriptFailed: (why: string) => `Das Skript kam nicht auf die Seite: ${why}`,
  subtitlesLaid: (shown: number, waiting: number, homeless: number) =>
    [
      shown === 1 ? '1 Text wurde auf die Seiten gesetzt.' : `${shown} Texte wurden auf die Seiten gesetzt.`,
      ...(waiting > 0
        ? [`${waiting} ${waiting === 1 ? 'wartet' : 'warten'} auf Einzelbilder, die keine Seite zeigt.`]
        : []),
      ...(homeless > 0
        ? [`${homeless} ${homeless === 1 ? 'fand' : 'fanden'} kein Einzelbild mit Platz in der Nähe.`]
        : []),
    ].join(' '),
  subtitlesThere: 'Alle ihre Untertitel sind schon da.',
  subtitlesSkipped: (n: number, why: readonly string[]) =>
    `${n === 1 ? 'Ein Untertitel wurde' : `${n} Untertitel wurden`} übersprungen: ${why.join(' ')}`,
  textGuessed: (encoding: string) => `Sie ist nicht in UTF-8, deshalb wurde ihr Text als ${encoding} gelesen.`,
  textLost: (n: number) =>
    n === 1 ? '1 Zeichen konnte nicht gelesen werden.' : `${n} Zeichen konnten nicht gelesen werden.`,
  changeEncoding: 'Kodierung ändern',
  encodingOf: (name: string) => `Kodierung von ${name}`,
  encoding: 'Kodierung',
  encodingPreview: 'Vorschau',
  readAgain: 'Erneut lesen',
  wordsWaiting: (n: number) => (n === 1 ? '1 nicht platzierter Text' : `${n} nicht platzierte Texte`),
  wordsWaitingWhy:
    'Ein Text kommt zurück, wenn eine Seite sein Foto wieder zeigt. Ein Text ohne Foto bleibt hier, bis du ihn auf eine Seite setzt.',
  putWaiting: (text: string) => `Auf diese Seite setzen: ${text}`,
  dropWaiting: (text: string) => `Verwerfen: ${text}`,
  dropAllWaiting: 'Alle verwerfen',
};
