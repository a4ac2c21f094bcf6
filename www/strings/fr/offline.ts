export const offlineStrings = {
  newVersion: 'Une nouvelle version est prête.',
  reload: 'Recharger',
  notReloaded: 'L’application n’a pas été rechargée, car votre travail n’est pas enregistré.',
  install: 'Installer',
  installHelp: 'Ouvre Inkpanel dans sa propre fenêtre, même sans connexion',
  sharedLost:
    'Les fichiers partagés ne sont pas arrivés. Le stockage de ce navigateur est peut-être plein. Ajoutez les photos ici.',
  launchFailed: (name: string) => `${name} n’a pas pu être ouvert. Ajoutez-le ici.`,
  noDetectorOffline:
    'La détection des visages doit être téléchargée une fois. Sans connexion, les photos sont cadrées d’après le contraste.',
};
