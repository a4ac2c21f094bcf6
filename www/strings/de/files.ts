/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'In der Datei',
  cargoFileHelp: {
    project: 'Lass die Datei hier fallen, um sie weiter zu bearbeiten. Sie findet ihre Fotos auf diesem Gerät.',
    photos:
      'Enthält deine Originalfotos und öffnet sich daher auf jedem Gerät. Alle, die die Datei haben, können sie sehen.',
    none: 'Nur die Seiten.',
  },
  packingPhotos: (percent: string) => `Die Fotos werden zur Datei hinzugefügt, ${percent}`,
  photosTooLarge: 'Zusammen sind die Fotos zu groß für ein PNG. Speichere stattdessen das Projekt als Datei.',
  savingProject: (done: number, total: number) => `Speichert das Projekt, ${Math.floor(done)} von ${total} Dateien`,
  damagedInArchive: (archive: string) => `Sie ist in ${archive} beschädigt.`,
  noPicturesInside: 'Darin ist kein Bild.',
  unknownJson: 'Das ist weder ein Layout noch ein Stil von Inkpanel.',
};
