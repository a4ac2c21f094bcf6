/** Words of files that carry a storyboard, and of archives. */

export const fileStrings = {
  cargoFile: 'Dans le fichier',
  cargoFileHelp: {
    project: 'Déposez le fichier ici pour le modifier de nouveau. Il retrouve ses photos sur cet appareil.',
    photos: 'Contient vos photos d’origine, et s’ouvre donc sur tout appareil. Quiconque a le fichier peut les voir.',
    none: 'Seulement les pages.',
  },
  packingPhotos: (percent: string) => `Ajout des photos, ${percent}`,
  photosTooLarge: 'ensemble, les photos sont trop lourdes pour un PNG. Enregistrez plutôt le projet dans un fichier.',
  savingProject: (done: number, total: number) => `Enregistrement du projet, ${Math.floor(done)} fichiers sur ${total}`,
  damagedInArchive: (archive: string) => `elle est endommagée dans ${archive}.`,
  noPicturesInside: 'il ne contient aucune image.',
  unknownJson: 'ce n’est ni un gabarit ni un style d’Inkpanel.',
  filesSkipped: (n: number) =>
    n === 1
      ? '1 fichier qu’un système ou un programme range à côté des photos a été ignoré.'
      : `${n} fichiers que des systèmes et des programmes rangent à côté des photos ont été ignorés.`,
  /** `remedy`: a request to the user */
  unsupportedKind: (name: string, remedy: string) => `ce type de fichier (${name}) ne peut pas être lu. ${remedy}`,
  remedies: {
    jpeg: 'Enregistrez-le en JPEG avec un programme qui l’ouvre.',
    unpack: 'Décompressez-le et ajoutez ses images, ou mettez-les dans un ZIP.',
    pages: 'Enregistrez ses pages en PNG ou JPEG.',
    mp4: 'Convertissez-le en MP4 avec une vidéo H.264.',
    srt: 'Convertissez-le en SRT ou WebVTT.',
    fountain: 'Exportez-le en Fountain.',
    csv: 'Enregistrez-le en CSV.',
    text: 'Enregistrez-le en texte brut.',
  },
  boardFile:
    'c’est un scénario ou un tableau. Ouvrez le storyboard et choisissez « Importer un scénario ou un tableau ».',
  liveVideos: (n: number) =>
    n === 1
      ? '1 vidéo d’une Live Photo n’a pas été ajoutée, seulement sa photo.'
      : `${n} vidéos de Live Photos n’ont pas été ajoutées, seulement leurs photos.`,
  addLiveVideos: (n: number): string => (n === 1 ? 'Ajouter la vidéo' : 'Ajouter les vidéos'),
};
