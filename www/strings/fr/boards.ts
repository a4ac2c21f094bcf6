/** Strings of the storyboard: shot list, sheets, import and export. */

export const boardsStrings = {
  boards: {
    seen: 'Affichage',
    comic: 'BD',
    board: 'Storyboard',
    sheets: 'Feuilles du storyboard',
    shots: 'Plans',
    picture: 'Image',
    order: 'Ordre',
    columns: {
      scene: 'Scène',
      number: 'Plan',
      length: 'Durée',
      action: 'Action',
      dialogue: 'Dialogue',
      notes: 'Notes',
    },
    /** the columns of a list that is saved */
    heading: ['Scène', 'Plan', 'Image', 'Film', 'Timecode', 'Durée', 'Images', 'Action', 'Dialogue', 'Notes'],
    /** on the sheets; `{page}` and `{count}` become numbers */
    labels: { scene: 'Scène', dialogue: 'Dialogue', notes: 'Notes', page: 'Page {page} sur {count}' },
    count: (count: number) => (count === 1 ? '1 plan' : `${count} plans`),
    shot: (number: string) => `plan ${number}`,
    up: (number: string) => `Monter le plan ${number}`,
    down: (number: string) => `Descendre le plan ${number}`,
    help: 'Entrée passe au plan suivant, Tab au champ suivant, Échap abandonne la saisie. Alt avec les flèches déplace un plan. Les durées sont en secondes (2), en secondes et images (2:12) ou en images (36f). On peut coller les cellules d’un tableur.',
    followPages: 'Suivre l’ordre des pages',
    dragHelp: 'Faites glisser pour le déplacer.',
    copy: 'Copier le tableau',
    copied: 'La liste a été copiée. Vous pouvez la coller dans un tableur.',
    newColumn: 'Nouvelle colonne',
    addColumn: 'Ajouter la colonne',
    removeColumn: (name: string) => `Retirer la colonne ${name}`,
    noLength: (text: string) =>
      `« ${text} » n’est pas une durée : écrivez des secondes (2), des secondes et images (2:12) ou des images (36f).`,
    pasteLost: (count: number) =>
      count === 1
        ? '1 cellule collée dépassait du tableau et a été ignorée.'
        : `${count} cellules collées dépassaient du tableau et ont été ignorées.`,
    filmBoard: 'Storyboard de film',
    perSheet: 'Vignettes par feuille',
    aspect: 'Format',
    rate: 'Images par seconde',
    beside: 'Texte à côté des vignettes',
    ruled: 'Fiche : lignes à remplir',
    author: 'Par',
    date: 'Date',
    logo: 'Logo',
    chooseLogo: 'Choisir un logo',
    removeLogo: 'Retirer le logo',
    logoFile: 'Image du logo',
    noLogo: (name: string) =>
      `${name} n’est pas une image que le navigateur peut montrer. Choisissez un fichier PNG, JPEG, WebP ou SVG.`,
    brokenLogo: 'Le logo est illisible. Retirez-le ou choisissez-en un autre.',
    saveAs: 'Enregistrer en',
    saveBoard: 'Enregistrer le storyboard',
    ways: { pdf: 'Storyboard, PDF', zip: 'Storyboard, fichiers PNG dans un ZIP' },
    importFile: 'Importer un scénario ou un tableau',
    tooLarge: (name: string) => `${name} est trop gros pour un scénario ou un tableau.`,
    nothingIn: (name: string) => `Rien dans ${name} ne correspond aux plans.`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name} : 1 plan a été rempli.` : `${name} : ${count} plans ont été remplis.`,
    quoted: (text: string) => `« ${text} »`,
    left: (count: number, lines: string) =>
      count === 1
        ? `1 ligne ne correspond à aucun plan : ${lines}.`
        : `${count} lignes ne correspondent à aucun plan : ${lines}.`,
    cellsLeft: (count: number, cells: string) =>
      count === 1
        ? `1 cellule a été omise ou raccourcie : ${cells}.`
        : `${count} cellules ont été omises ou raccourcies : ${cells}.`,
    columnsLeft: (columns: string) => `Le storyboard n’a pas de place pour ces colonnes : ${columns}.`,
    noSheets: (why: string) => `Le storyboard n’a pas pu être composé : ${why}`,
    missing: 'Le storyboard n’a pas pu être chargé. Vérifiez la connexion et réessayez.',
    sheet: (n: number, of: number) => `Feuille ${n} sur ${of}`,
    listSaved: 'La liste des plans a été enregistrée.',
    listHelp: 'Tous les plans de l’album avec leurs données, dans l’ordre du storyboard.',
  },
};
