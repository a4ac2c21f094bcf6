const photos = (n: number) => (n < 2 ? `${n} photo` : `${n} photos`);
const pages = (n: number) => (n < 2 ? `${n} page` : `${n} pages`);

export const bookStrings = {
  book: {
    name: 'Pages',
    page: (n: number, of: number) => `Page ${n} sur ${of}`,
    add: 'Ajouter une page',
    addHelp: 'Insérer une page après celle-ci',
    addMore: (left: number) => `Ajouter une page : ${photos(left)} sur aucune page pour l’instant`,
    tools: 'Outils de page',
    remove: 'Retirer la page',
    turnBack: 'Page précédente',
    turnOn: 'Page suivante',
    earlier: 'Avancer la page',
    later: 'Reculer la page',
    make: 'Créer un livre',
    makeHelp: (n: number) => `Couverture, chapitres par jour, légendes et numéros de page, avec vos ${n} photos`,
    makeChapters: 'Créer un livre, un style par jour',
    makeChaptersHelp: 'Comme « Créer un livre », avec un autre style pour chaque jour',
    made: (n: number) => `Votre livre a ${n} pages.`,
    looking: 'Lecture de vos photos…',
    making: (done: number, of: number) => `Page ${done + 1} sur ${of}…`,
    spreadAlbum: 'Faire des pages de toutes les photos',
    spreadHelp: (n: number) => `Plusieurs pages avec les ${n} photos, dans leur ordre`,
    spreadAsk: 'Les nouvelles pages remplacent les vôtres, y compris vos retouches.',
    spreadYes: 'Remplacer les pages',
    styleAll: 'Ce style sur toutes les pages',
    left: (n: number) => `${photos(n)} sur aucune page`,
    reading: 'Les photos sont encore en cours de lecture.',
    removed: (n: number) => `La page ${n} a été retirée.`,
    spread: (n: number, on: number) => `${photos(n)} sur ${pages(on)}.`,
    repeats: (n: number) =>
      n === 1
        ? 'Il n’y a pas assez de photos inutilisées. Cette page répète 1 photo.'
        : `Il n’y a pas assez de photos inutilisées. Cette page répète ${n} photos.`,
    takeBack: 'Restaurer les pages',
    dragHelp: 'Faites-la glisser pour la déplacer, ou Alt avec une flèche',
  },
  version: (n: number, of: number) => `Version ${n} sur ${of} de cette page : montrer toutes les versions`,
  previousHelp: 'Afficher la version précédente de cette page',
  nextHelp: 'Afficher la version suivante de cette page',
};
