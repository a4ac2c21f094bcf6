import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'le stockage de ce navigateur est plein',
  refused: 'ce navigateur bloque ici le stockage des sites',
};

export const storageStrings = {
  // Saving
  saveState: {
    empty: '',
    saving: 'Enregistrement…',
    saved: 'Enregistré',
    missing: 'Enregistré en partie',
    full: 'Non enregistré',
    refused: 'Non enregistré',
    failed: 'Non enregistré',
  },
  savingCount: (done: number, total: number) => `Enregistrement ${done}/${total}`,
  saveHelp: 'Votre travail est enregistré dans ce navigateur, sur cet appareil',
  notSaved: (why: string, message: string) =>
    `Votre travail n’est pas enregistré : ${TROUBLE[why] ?? message.replace(/\.$/, '')}. Il sera perdu si vous fermez cet onglet.`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)} : non enregistré, ${names.length === 1 ? 'le fichier n’est plus lisible' : 'les fichiers ne sont plus lisibles'}. Tout le reste est enregistré.`,
  photosNotHere: (names: readonly string[], of: number) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} photos sur ${of}` : one ? 'La photo' : `Les ${of} photos`;
    return `${one && of > 1 ? `1 photo sur ${of}` : which} ${one ? 'n’est' : 'ne sont'} pas dans ce navigateur : ${some(names)}. ${one ? 'Choisissez-la ou déposez-la' : 'Choisissez-les ou déposez-les'} ici : chacune retrouve sa place.`;
  },
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)} : plus dans ce navigateur, mais les images prises y sont. Pour en prendre d’autres, ajoutez de nouveau la vidéo.`,
  photosNeverSaved: (names: readonly string[]) =>
    `L’application s’est fermée avant l’enregistrement de ${some(names)}. ${names.length === 1 ? 'Choisissez-la' : 'Choisissez-les'} de nouveau.`,
  saveAgain: 'Enregistrer à nouveau',
  goOnWithout: 'Continuer sans',
  saveToFile: 'Enregistrer dans un fichier',
  conflict: 'Un autre onglet a modifié ce projet. Cet onglet continue avec une copie.',

  // Projects
  projects: 'Projets',
  projectName: 'Nom du projet',
  untitled: 'Sans titre',
  newProject: 'Nouveau projet',
  openProject: 'Ouvrir un fichier de projet',
  saveProject: 'Enregistrer un fichier de projet',
  projectFile: 'Fichier de projet',
  openNamed: (name: string) => `Ouvrir ${name}`,
  duplicateNamed: (name: string) => `Dupliquer ${name}`,
  deleteNamed: (name: string) => `Supprimer ${name}`,
  renameNamed: (name: string) => `Renommer ${name}`,
  newNameOf: (name: string) => `Nouveau nom de ${name}`,
  sampleAlbum: 'Album d’exemple',
  openNow: 'Ouvert maintenant',
  projectAbout: (photos: number, when: string) =>
    `${photos < 2 ? `${photos} photo` : `${photos} photos`}${when && `, ${when}`}`,
  noProjects: 'Votre travail s’enregistre ici automatiquement.',
  projectDeleted: (name: string) => `${name} a été supprimé.`,
  bringBack: 'Restaurer',
  projectNotOpened: (why: string) => `Le projet n’a pas pu être ouvert : ${why}`,
  projectFileNotOpened: (name: string, why: string) => `${name} n’a pas pu être ouvert : ${why}`,
  projectNotSaved: (why: string) => `Le projet n’a pas pu être enregistré dans un fichier : ${why}`,
  projectReasons: {
    'damaged-project': 'il est endommagé, ou n’est pas un projet d’Inkpanel. Votre page n’a pas changé.',
    'too-large-project': 'il dépasse les limites d’un projet. Votre page n’a pas changé.',
    'silent-project': 'la lecture du fichier a été interrompue après une minute. Vérifiez le disque et réessayez.',
    'newer-project':
      'il a été enregistré avec une version plus récente d’Inkpanel. Rechargez cet onglet pour mettre à jour.',
    'not-saved':
      'votre travail n’est pas enregistré. Enregistrez-le d’abord dans un fichier (Enregistrer un fichier de projet).',
    'missing-project': 'il a été supprimé.',
    'no-storage': 'ce navigateur bloque ici le stockage des sites.',
    'too-large': 'le fichier dépasserait 4 Go.',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `${others.length + 1} projets ont été ouverts, chacun à part. ${shown} est sur la page ; ${others.length === 1 ? `${others[0]} est` : `${others.length} autres sont`} dans Projets.`,
  photosWithProject: (n: number, name: string) =>
    n === 1
      ? `La photo qui l’accompagnait a été ajoutée à ${name}.`
      : `Les ${n} photos qui l’accompagnaient ont été ajoutées à ${name}.`,
  projectBroken: (name: string, why: string) => `${name} ne peut pas être montré : ${why}.`,
  brokenReasons: {
    'damaged-project': 'une partie est abîmée',
    'too-large-project': 'il dépasse les limites d’un projet',
    'newer-project':
      'il a été enregistré avec une version plus récente d’Inkpanel. Rechargez cet onglet pour mettre à jour',
  } as Record<string, string>,
  brokenOtherwise: 'une partie ne peut pas être dessinée',
  brokenKept: 'Le projet et ses photos sont inchangés.',
  partsLeftOut: (name: string, n: number) =>
    `${name} est ouvert sans ${n === 1 ? 'une partie qui n’a pas pu être lue' : `${n} parties qui n’ont pas pu être lues`}.`,
  openAnother: 'En ouvrir un autre',
  saveAsFile: 'Enregistrer en fichier',
  goBack: 'Rétablir la dernière bonne version',
  noGoodState: 'Il n’y a pas de version antérieure à rétablir.',
  wentBack: (name: string) => `La dernière bonne version de ${name} a été rétablie.`,
  openingProject: (name: string) => `Ouverture de ${name}`,
  openingLast: 'Ouverture de votre projet',
  openElsewhere: (name: string) => `${name} est ouvert dans un autre onglet.`,
  opensWhenFree: 'Il s’ouvre ici quand vous fermez l’autre onglet.',
  openCopy: 'Ouvrir une copie',

  // Pages shown
  pagesShown: 'Historique de la page',
  pagesShownAt: (n: number, of: number) => `Historique de la page, ${n}/${of}`,
  pageNumber: (n: number) => `Page ${n}`,
  versionFrom: (n: number) => `de la version ${n}`,
  favouritePage: 'Page favorite',
  favouritePages: 'Favorites seulement',
  versionNumber: (n: number) => `Version ${n}`,
  compareShort: 'Comparer',
  comparePage: (n: number) => `Comparer la version ${n}`,
  comparedAll: 'Afficher toutes les versions',
  compareSecond: 'Choisissez la deuxième version à comparer',
  noFavouritePages: 'Pas encore de favorites. Appuyez sur le cœur d’une page qui vous plaît.',
};
