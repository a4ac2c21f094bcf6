export const offlineStrings = {
  newVersion: 'Une nouvelle version est prête.',
  reload: 'Recharger',
  notReloaded: 'La page n’a pas été rechargée, car votre travail n’est pas enregistré.',
  install: 'Installer',
  installHelp: 'Ouvre Inkpanel dans sa propre fenêtre, même sans connexion',
  sharedLost:
    'Ce qui a été partagé n’est pas arrivé : le stockage de ce navigateur est peut-être plein. Ajoutez les photos ici.',
  launchFailed: (name: string) => `${name} n’a pas pu être ouvert. Ajoutez-le ici.`,
  noDetectorOffline:
    'Sans connexion, les visages ne peuvent pas encore être trouvés : les photos sont cadrées d’après le contraste en attendant.',
};
