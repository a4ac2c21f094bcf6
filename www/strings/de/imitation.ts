/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Stil aus einem Bild',
  styleFromPictureHelp: 'Überträgt das Aussehen einer Comicseite, eines Drucks oder eines Gemäldes auf deine Fotos',
  imitationAbout:
    'Wähle ein Bild mit dem Aussehen, das du möchtest: eine Comicseite, einen Druck, eine Zeichnung oder ein Gemälde. In wenigen Sekunden findet Inkpanel Stile, die deinem Foto dieses Aussehen geben. Das Bild bleibt auf diesem Gerät.',
  imitationDropHere: 'Oder lege hier ein Bild ab.',
  imitationChoose: 'Bild wählen',
  imitationOther: 'Anderes Bild',
  imitationFile: 'Bild mit dem gewünschten Stil',
  imitationAgain: 'Noch einmal suchen',
  imitationAnyway: 'Trotzdem suchen',
  imitating: 'Stile werden gesucht …',
  imitationProposals: 'Gefundene Stile',
  imitationPhotos: 'Foto für die Vorschau',
  imitationNone: 'Kein Stil kommt diesem Bild nahe. Versuche es mit einem anderen.',
  imitationNeedsPhotos: 'Wähle zuerst Fotos: Inkpanel zeigt die Stile auf einem davon.',
  dropForStyle: 'Hier oder mit gedrückter Alt-Taste loslassen, um den Stil eines Bildes zu übernehmen',
  imitationFound: (n: number) =>
    n === 1
      ? '1 Stil gefunden. Verwende, bearbeite oder speichere ihn, um ihn zu behalten.'
      : `${n} Stile gefunden. Verwende, bearbeite oder speichere einen, um ihn zu behalten.`,
  imitationName: (picture: string, place: number) => `Wie ${picture} ${place}`,
  imitationPictureOf: (name: string) => `Das Bild ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Dieses Bild ist zu klein. Jede Seite braucht mindestens 64 Pixel.',
    'blank-picture': 'Dieses Bild ist leer und hat daher keinen Stil.',
    'plain-photo':
      'Das sieht nach einem gewöhnlichen Foto ohne Linien, Druckfarben oder Malerei aus. Wähle eine Zeichnung, einen Druck oder ein Gemälde.',
    'imitation-missing': 'Die Stilsuche konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
    'worker-lost': 'Inkpanel ist beim Lesen dieses Bildes abgestürzt. Versuche es mit einem anderen.',
    'unreadable-file': 'Die Datei wurde verschoben, verändert oder gelöscht, seit du sie gewählt hast.',
    'unknown-format':
      'Das ist kein Bild, das gelesen werden kann. Wähle eine Datei in JPEG, PNG, WebP, AVIF, GIF, BMP oder TIFF.',
    damaged: 'Die Datei dieses Bildes ist beschädigt oder unvollständig.',
    'too-large': 'Dieses Bild ist zu groß.',
  } as Record<string, string>,
};
