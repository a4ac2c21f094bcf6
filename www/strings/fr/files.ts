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
};
