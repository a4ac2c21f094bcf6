const photos = (n: number) => (n === 1 ? '1 Foto' : `${n} Fotos`);

export function some(names: readonly string[]) {
  const rest = names.length - 3;
  return rest > 0 ? `${names.slice(0, 3).join(', ')} und ${rest} weitere` : names.join(', ');
}

export const pngStrings = {
  cargo: 'Im PNG',
  cargoKind: { project: 'Mit Projektdaten', photos: 'Mit Fotos', none: 'Ohne Projektdaten' },
  cargoHelp: {
    project: 'Lass das PNG hier fallen, um es weiter zu bearbeiten. Es findet seine Fotos auf diesem Gerät.',
    photos:
      'Enthält deine Originalfotos und öffnet sich daher auf jedem Gerät. Alle, die die Datei haben, können sie sehen.',
    none: 'Nur das Bild.',
  },
  cargoClean: 'Ort, Datum und Kamera deiner Fotos sind nie darin.',
  photosUnclean: (n: number) =>
    `${photos(n)} darin ${n === 1 ? 'verrät' : 'verraten'} vielleicht noch, wo und wann: Aus Dateien dieser Art kann Inkpanel das nicht entfernen.`,

  noProjectInside: 'Es ist ein Bild ohne Projektdaten.',
  pageOpened: (name: string) => `${name} ist wieder offen, als eigenes Projekt.`,
  photosMissing: (name: string, n: number, of: number) =>
    `${name} ist offen, aber auf diesem Gerät ${n === 1 ? 'fehlt' : 'fehlen'} ${n} von ${photos(of)}. Wähle ${n === 1 ? 'es' : 'sie'} oder lass ${n === 1 ? 'es' : 'sie'} hier fallen: Jedes kommt an seinen Platz zurück.`,
  photosBack: (n: number) => `${photos(n)} wieder an ${n === 1 ? 'seinem' : 'ihrem'} Platz.`,
  photosStillMissing: (n: number) =>
    `Es ${n === 1 ? 'fehlt' : 'fehlen'} noch ${photos(n)} dieser Seite. Wähle ${n === 1 ? 'es' : 'sie'} oder lass ${n === 1 ? 'es' : 'sie'} hier fallen: Jedes kommt an seinen Platz zurück.`,
  absentPhoto: (n: number) => `Fehlendes Foto ${n}`,
  choosePhotos: 'Fotos wählen',
  openedAsPicture: (name: string) =>
    `${name} ist jetzt ein Foto dieses Projekts. Die Fotos jener Seite sind nicht auf diesem Gerät.`,
  openAsProject: 'Als Projekt öffnen',
  useAsPhoto: 'Als Foto verwenden',
  backTo: (name: string) => `Zurück zu ${name}`,

  removeMetadata: 'Orts- und Kameradaten entfernen',
  removeMetadataHelp:
    'Für Dateien, die du weitergibst. Auch das Datum wird entfernt. Neue Bücher können die Fotos dann nicht nach Tagen ordnen.',
  /** @param unclean: files that kept their metadata; null if no metadata was removed */
  projectSaved: (unclean: readonly string[] | null) =>
    unclean === null
      ? 'Das Projekt wurde als Datei gespeichert, mit deinen Originalfotos. Ort, Datum und Kameradaten sind enthalten.'
      : unclean.length === 0
        ? 'Das Projekt wurde als Datei gespeichert, mit deinen Fotos in voller Größe, aber ohne Ort, Datum und Kamera.'
        : `Das Projekt wurde als Datei gespeichert, mit deinen Fotos in voller Größe. ${some(unclean)} ${unclean.length === 1 ? 'verrät' : 'verraten'} vielleicht noch, wo und wann: Aus Dateien dieser Art kann Inkpanel das nicht entfernen.`,
};
