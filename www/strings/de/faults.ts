export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}: ${why}`,
  filesFailed: (n: number) => `${n} Dateien konnten nicht gelesen werden.`,
  internalError: (what: string) => `es trat ein interner Fehler auf: ${what}`,
  showList: 'Liste zeigen',
  moreFiles: (n: number) => `und ${n} weitere`,
  /** The core's own sentences are English, so all its codes are here. */
  reasons: {
    'animatic-encoder':
      'der Browser hat das Kodieren abgebrochen. Eine kleinere Größe oder eine andere Dateiart hilft.',
    'animatic-long': 'eine GIF-Datei fasst höchstens eine Minute. MP4 oder WebM wählen, oder kürzere Einstellungen.',
    'animatic-sound': 'dieser Browser kodiert für solche Dateien keinen Ton. WebM wählen oder den Ton weglassen.',
    'sound-unread': 'der Browser kann den Ton nicht lesen. In MP3 oder WAV umwandeln.',
    'film-cut': 'Die Datei ist unvollständig (ihr Index fehlt). Kopiere sie noch einmal von der Quelle.',
    'film-empty': 'Das Video enthält keine Bilder.',
    'films-missing': 'Der Videoleser konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
    'texts-missing':
      'Der Leser für Textdateien konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
    'worker-lost': 'Inkpanel ist beim Lesen zweimal abgestürzt, daher wurde die Datei ausgelassen.',
    'unreadable-file': 'Die Datei wurde verschoben, geändert oder gelöscht, nachdem du sie gewählt hast.',
    'not-text': 'Das ist keine Textdatei, oder ihre Kodierung ist unbekannt. Speichere sie als UTF-8.',
    'unreadable-entry':
      'Der Browser kann sie nicht lesen. Vielleicht liegt sie nur in der Cloud, oder die Verknüpfung ist defekt.',
    'unreadable-folder': 'Der Browser kann nicht alle Dateien dieses Ordners lesen.',
    'unknown-format': 'Das ist kein Bild, das Inkpanel lesen kann (JPEG, PNG, WebP, GIF, BMP oder TIFF).',
    damaged: 'Die Datei ist beschädigt oder unvollständig.',
    unsupported: 'Diese Art von Datei kann nicht gelesen werden.',
    'too-large': 'Sie ist zu groß.',
    'no-decoder':
      'Dieser Browser kann diese Art von Foto nicht lesen. Speichere es als JPEG oder öffne diese Seite in einem anderen Browser.',
    'no-room': 'Der Browser hat keinen Platz für das Foto.',
    'missing-photo': 'Das Foto ist nicht geladen.',
    'no-photos': 'Es gibt kein Foto, das sich verwenden lässt.',
    encode: 'Die Seite konnte nicht kodiert werden.',
    'video-codec': 'Dieser Browser kann das Video nicht dekodieren.',
    'video-decoder': 'Dieser Browser kann das Video nicht dekodieren.',
    'video-format': 'Das ist kein vollständiges Video in MP4, MOV, WebM oder Matroska.',
    'video-empty': 'Es hat kein Bild, nur Ton.',
    'video-memory': 'Der Speicher reicht nicht für ein Einzelbild.',
    'video-worker': 'Der Leser des Videos ist ausgefallen.',
    'words-missing': 'Die Schriften konnten nicht geladen werden.',
    'files-missing':
      'Der Export solcher Dateien konnte nicht geladen werden. Versuche es noch einmal oder speichere ein PNG.',
    'decoders-missing':
      'Der Decoder für diese Fotos konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
    'painters-missing': 'Die Maler konnten nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
    'core-missing': 'Das Programm konnte nicht geladen werden.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n === 1 ? '1 Datei wurde' : `${n} Dateien wurden`} ausgelassen: Ein Projekt fasst ${most} Fotos.`,
  /** Reasons by error code that name the kind of file. */
  reasonsOf: {
    'film-container': (what: string) =>
      `Inkpanel kann dieses Videoformat nicht lesen (${what}). Wandle es in MP4 mit H.264-Video um, zum Beispiel mit HandBrake oder ffmpeg.`,
    'film-codec': (what: string) =>
      `Dieser Browser kann ${what}-Video nicht dekodieren. Wandle es in MP4 mit H.264-Video um, zum Beispiel mit HandBrake oder ffmpeg.`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) =>
    `${name}: ${share} des Bildes sind beschädigt und werden grau gezeichnet.`,
  photoCoarse: (name: string, share: string) =>
    `${name}: In ${share} des Bildes fehlen Einzelheiten, weil die Datei beschädigt oder unvollständig ist.`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name} ist unvollständig: Es endet bei ${till} von ${whole}. Alle Einzelbilder sind aus diesem Teil.`,
  noUsablePhoto:
    'Keine dieser Dateien ließ sich verwenden. Wähle Fotos in JPEG, PNG, WebP, AVIF, GIF, BMP oder TIFF, oder ein Video.',
  noSamples: 'Das Beispielalbum konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
  noPhotosInUse: 'Kein Foto ist in Gebrauch. Hake unter Fotos eines an, um eine Seite zu bekommen.',
  panelFailed: (why: string) => `Ein Panel konnte nicht gezeichnet werden: ${why}`,
  partMissing:
    'Dieser Teil von Inkpanel konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
  notDone: (why: string) => `Das ging nicht: ${why}`,
  coreFailed: (why: string) => `Inkpanel konnte nicht starten: ${why}`,
  locked: { layout: 'Das Layout ist fixiert.', style: 'Der Stil ist fixiert.', photos: 'Die Fotos sind fixiert.' },
};
