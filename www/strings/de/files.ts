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
  filesSkipped: (n: number) =>
    n === 1
      ? '1 Datei, die Systeme oder Programme neben Fotos ablegen, wurde übersprungen.'
      : `${n} Dateien, die Systeme oder Programme neben Fotos ablegen, wurden übersprungen.`,
  /** `remedy`: a request to the user */
  unsupportedKind: (name: string, remedy: string) =>
    `Diese Art von Datei (${name}) kann nicht gelesen werden. ${remedy}`,
  remedies: {
    jpeg: 'Speichere sie in einem Programm, das sie öffnet, als JPEG.',
    unpack: 'Entpacke sie und füge ihre Bilder hinzu, oder packe diese als ZIP.',
    pages: 'Speichere ihre Seiten als PNG oder JPEG.',
    mp4: 'Wandle sie in MP4 mit H.264-Video um.',
    srt: 'Wandle sie in SRT oder WebVTT um.',
    fountain: 'Exportiere sie als Fountain.',
    csv: 'Speichere sie als CSV.',
    text: 'Speichere sie als reinen Text.',
  },
  boardFile: 'Das ist ein Drehbuch oder eine Tabelle. Öffne das Storyboard und wähle „Drehbuch oder Tabelle laden“.',
  liveVideos: (n: number) =>
    n === 1
      ? '1 Video eines Live-Fotos wurde nicht hinzugefügt, nur das Foto.'
      : `${n} Videos von Live-Fotos wurden nicht hinzugefügt, nur die Fotos.`,
  addLiveVideos: (n: number): string => (n === 1 ? 'Video hinzufügen' : 'Videos hinzufügen'),
};
