/** A style from a picture. */

export const imitationStrings = {
  styleFromPicture: 'Stil aus einem Bild',
  styleFromPictureHelp:
    'Überträgt das Aussehen eines Bildes, einer Comicseite, eines Drucks oder Gemäldes, auf deine Fotos',
  imitationAbout:
    'Wähle ein Bild, dessen Aussehen du möchtest: eine Comicseite, einen Druck, eine Zeichnung, ein Gemälde. In wenigen Sekunden werden Stile gesucht, die deinem eigenen Foto dieses Aussehen geben. Das Bild bleibt auf diesem Gerät.',
  imitationDrop: 'Du kannst ein Bild auch mit gedrückter Alt-Taste irgendwo ablegen.',
  imitationChoose: 'Bild wählen',
  imitationOther: 'Anderes Bild',
  imitationFile: 'Bild, dessen Stil gesucht wird',
  imitationAgain: 'Noch einmal suchen',
  imitationAnyway: 'Trotzdem suchen',
  imitating: 'Stile werden gesucht …',
  imitationProposals: 'Gefundene Stile',
  imitationPhotos: 'Foto zum Ausprobieren',
  imitationNone: 'Kein Stil kam diesem Bild nahe. Versuch es mit einem anderen.',
  imitationNeedsPhotos: 'Wähle zuerst Fotos: Der Stil eines Bildes wird an einem davon ausprobiert.',
  dropForStyle: 'Hier oder mit gedrückter Alt-Taste loslassen, um den Stil eines Bildes zu übernehmen',
  imitationFound: (n: number) =>
    n === 1
      ? '1 Stil gefunden. Er gehört dir, wenn du ihn nimmst, bearbeitest oder speicherst.'
      : `${n} Stile gefunden. Einer gehört dir, wenn du ihn nimmst, bearbeitest oder speicherst.`,
  imitationName: (picture: string, place: number) => `Wie ${picture} ${place}`,
  imitationPictureOf: (name: string) => `Das Bild ${name}`,
  /** Why nothing was found, by error code. */
  imitationReasons: {
    'small-picture': 'Dieses Bild ist zu klein, um einen Stil daraus zu lesen: Jede Seite braucht 64 Pixel.',
    'blank-picture': 'Dieses Bild ist leer: Es steckt kein Stil darin.',
    'plain-photo':
      'Das sieht nach einem gewöhnlichen Foto aus: Es hat keine Linien, Druckfarben oder Malerei zum Übernehmen. Wähle eine Zeichnung, einen Druck oder ein Gemälde.',
    'imitation-missing':
      'Was Stile in Bildern findet, konnte nicht geladen werden. Versuche es mit Verbindung noch einmal.',
    'worker-lost': 'Beim Lesen dieses Bildes blieb das Programm stehen. Versuch es mit einem anderen.',
    'unreadable-file': 'Die Datei wurde verschoben, verändert oder gelöscht, seit du sie gewählt hast.',
    'unknown-format':
      'Das ist kein Bild, das gelesen werden kann. Wähle eine Datei in JPEG, PNG, WebP, AVIF, GIF, BMP oder TIFF.',
    damaged: 'Die Datei dieses Bildes ist beschädigt oder abgeschnitten.',
    'too-large': 'Dieses Bild ist zu groß.',
  } as Record<string, string>,
};
