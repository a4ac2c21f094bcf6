/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'In der Datei',
  cargoFileHelp: {
    project: 'Lass die Datei hier fallen, um daran weiterzuarbeiten. Sie findet ihre Fotos auf diesem Gerät.',
    photos: 'Öffnet sich auf jedem Gerät, samt Fotos. Wer die Datei hat, hat auch sie.',
    none: 'Nur die Seiten, sonst nichts.',
  },
  packingPhotos: (percent: string) => `Die Fotos kommen hinein, ${percent}`,
  photosTooLarge: 'Zusammen sind die Fotos zu groß für ein PNG. Speichere stattdessen das Projekt als Datei.',
  savingProject: (done: number, total: number) => `Speichert das Projekt, ${Math.floor(done)} von ${total} Dateien`,
  damagedInArchive: (archive: string) => `Sie ist in ${archive} beschädigt.`,
  noPicturesInside: 'Darin ist kein Bild.',
  unknownJson: 'Das ist weder ein Layout noch ein Stil von Inkpanel.',
};
