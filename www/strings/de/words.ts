type Kind = 'caption' | 'balloon' | 'effect';

export const wordStrings = {
  words: 'Text',
  addWord: { caption: 'Textkasten hinzufügen', balloon: 'Sprechblase hinzufügen', effect: 'Soundwort hinzufügen' },
  wordShort: { caption: 'Textkasten', balloon: 'Sprechblase', effect: 'Soundwort' },
  /** Text of a new item. */
  wordSample: { caption: 'Unterdessen…', balloon: 'Hallo!', effect: 'WUMM!' },
  wordKind: { caption: 'Textkasten', balloon: 'Sprechblase', effect: 'Soundwort' },
  word: (kind: Kind, text: string) => `${wordStrings.wordKind[kind]}: ${text}`,
  wordKeys: 'Eingabe ändert den Text, Pfeile bewegen ihn, Entf entfernt ihn',
  wordText: (name: string) => `Text von ${name}`,
  wordTail: (name: string) => `Dorn von ${name}`,
  tailKeys: 'Pfeile bewegen die Spitze des Dorns',
  wordList: 'Text auf der Seite',
  narration: 'Titel und Bildtexte',
  narrationHelp: 'Neue Seiten erhalten den Namen des Albums und Bildtexte mit Datum, Uhrzeit und Ort.',
  noWords: 'Noch kein Text.',
  shape: 'Form',
  shapes: { oval: 'Rede', thought: 'Gedanke', shout: 'Schrei', whisper: 'Flüstern', radio: 'Funk' },
  editWord: 'Text ändern',
  formatWord: 'Format',
  moveWord: 'Bewegen nach…',
  pointTail: 'Dorn zeigt auf…',
  removeTail: 'Dorn entfernen',
  placeWord: 'Auto-Position',
  removeWord: 'Text entfernen',
  wordX: 'X',
  wordY: 'Y',
  wordWidth: 'Breite',
  wordSize: 'Schriftgröße',
  wordAuto: 'automatisch',
  wordAngle: 'Winkel',
  wordArc: 'Bogen',
  wordColor: 'Schriftfarbe',
  wordFill: 'Füllung',
  wordFont: 'Schrift',
  fonts: { 'comic-neue': 'Comic Neue', 'comic-neue-bold': 'Comic Neue fett', bangers: 'Bangers' },
  wordCut: 'Der Text passte nicht und wurde abgeschnitten.',
  wordModes: { move: 'Klicke, wohin es soll', tail: 'Klicke, worauf er zeigen soll' },
  wordRemoved: (name: string) => `${name} wurde entfernt.`,
  wordsFull: (most: number) =>
    `Eine Seite kann höchstens ${most} Texte haben. Entferne einige, bevor du mehr hinzufügst.`,
  wordsFailed: (why: string) => `Der Text konnte nicht gezeichnet werden: ${why}`,

  // Subtitles
  addSubtitles: 'Untertitel hinzufügen',
  subtitlesFile: 'Untertiteldatei',
  subtitlesAs: 'Als',
  subtitlesKinds: { caption: 'Textkästen', balloon: 'Sprechblasen' },
  subtitlesNoFrames: 'Es gibt noch keine Seite. Füge erst Fotos oder das Video hinzu.',
  subtitlesNoMatch: 'Kein Untertitel liegt nahe der Zeit eines Einzelbilds.',
  subtitlesLeft: (n: number, of: number) =>
    `${of} Untertitel wurden gelesen; ${n} weitere ${n === 1 ? 'war zu viel und wurde' : 'waren zu viele und wurden'} ausgelassen.`,
  subtitlesCut: (n: number) =>
    n === 1
      ? 'Ein Untertitel ist zu lang, daher wurde sein Ende ausgelassen.'
      : `${n} Untertitel sind zu lang, daher wurden ihre Enden ausgelassen.`,
  subtitleErrors: {
    empty: 'Es sind keine Untertitel darin.',
    binary: 'Es ist kein lesbarer Text.',
    large: 'Sie ist größer als 5 MB.',
    time: (line: number, text: string) => `Zeile ${line}: „${text}“ ist keine Zeit wie 00:01:02,500 --> 00:01:04,000.`,
    order: (line: number) => `Zeile ${line}: Der Untertitel endet, bevor er beginnt.`,
    header: 'Sie beginnt nicht mit WEBVTT.',
    stray: (line: number, text: string) => `Zeile ${line}: Hier wurde eine Zeit erwartet, nicht „${text}“.`,
  },
};
