export const photoStrings = {
  photos: 'Photos',
  usePhoto: (name: string) => `Utiliser ${name}`,
  pickPhoto: (name: string) => `Choisir ${name}`,
  pickLong:
    'Cliquez pour la mettre dans la case sélectionnée ou dans la prochaine cliquée ; ou faites-la glisser sur une case',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `dans la case ${panel}` : `page ${page}, case ${panel}`,
  youLeftOut: 'Vous l’avez exclue',
  leftOut: (name: string) => `${name} a été exclue.`,
  starPhoto: (name: string) => `Mettre ${name} en avant`,
  starLong: 'Agrandir la case de cette photo, et la montrer en grand à chaque mélange',
  starLocked: 'Photo mise en avant. La mise en page ou la case est verrouillée, la case garde donc sa taille.',
  starKeepsSize:
    'Photo mise en avant. Cette mise en page n’a pas de place pour une case plus grande ; Mélanger montre la photo en grand.',
  removePhoto: (name: string) => `Retirer ${name}`,
  photoMissing: 'Absente',
  addPhotos: 'Ajouter des photos',
  kept: 'Utilisées',
  unseen: {
    waits: 'Pas encore montrée',
    text: 'Pas montrée : on dirait une page de texte',
    small: 'Pas montrée : trop peu de pixels',
  },
  setAside: 'Exclues',
  setAsideWhy: 'Semblables ou floues. Cochez-en une pour l’utiliser.',
  choice: 'Choix des photos',
  alike: 'Exclure les semblables',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, presque identiques`
      : bits < 11
        ? `${bits}, la même image`
        : bits < 14
          ? `${bits}, très semblables`
          : `${bits}, un peu semblables`,
  alikeKept: (kept: number, all: number) => (kept < 2 ? `${kept} utilisée sur ${all}` : `${kept} utilisées sur ${all}`),
  order: 'Ordre',
  orders: { time: 'Date de prise de vue', name: 'Nom de fichier' },
  stackWhy: 'Ces photos se ressemblent. La photo cochée sert ; cochez-en d’autres ou utilisez-en une autre.',
  stackOf: (count: number) => `${count} semblables`,
  openStack: (count: number, name: string) => `Voir les ${count} photos semblables à ${name}`,
  take: 'Utiliser',
  takeInstead: (name: string) => `Utiliser plutôt ${name}`,
  credit: ({ title, author, licence }: { title: string; author: string; licence: string }) =>
    `${title}, de ${author} (${licence})`,
  photoCount: (used: number, all: number) => (used === all ? `${all}` : `${used} sur ${all}`),
  reading: (done: number, total: number) => `Lecture des photos, ${done} sur ${total}`,
  cancelReading: 'Arrêter la lecture',

  // Videos
  videos: 'Vidéos',
  videoFrames: (count: number) => (count < 2 ? `${count} image` : `${count} images`),
  trimStart: 'Début',
  trimEnd: 'Fin',
  frames: 'Images de la vidéo',
  lookingThrough: (name: string, percent: string) => `Analyse de ${name}, ${percent}`,
  takeFrames: 'Utiliser ces images',

  showSubjects: 'Montrer les sujets',
  finding: (done: number, total: number) => `Détection des visages et des objets : ${done} photos sur ${total}`,
  masking: (done: number, total: number) => `Détection des sujets : ${done} photos sur ${total}`,
  stopMasking: 'Arrêter la détection des sujets',
  goOnMasking: 'Reprendre la détection des sujets',
  noDetector: 'La détection des visages n’est pas disponible ici : les photos sont cadrées d’après le contraste.',
};
