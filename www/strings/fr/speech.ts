/** Strings of lettering tools, scripts and subtitles. */

export const speechStrings = {
  wordResize: 'Redimensionner le texte',
  resizeKeys: 'Les flèches l’élargissent ou le rétrécissent',
  wordTurn: 'Tourner le texte',
  turnKeys: 'Les flèches le tournent d’un degré, avec Maj de 15',
  wordMissing: (letters: string) =>
    `Aucune police n’a ces caractères, ils apparaissent donc comme des points d’interrogation : ${letters}`,
  wordForeign: 'Certains caractères utilisent une police de cet appareil.',
  wordSlant: 'Inclinaison',
  wordOutline: 'Contour',
  wordCapitals: 'En capitales',
  wordVertical: 'Texte vertical',
  wordJoin: 'Relier à la bulle précédente',
  wordBoxless: 'Sans cadre',
  wordBehind: 'Derrière le sujet',
  wordBehindWhy: 'Le texte reste devant tant que la photo n’a pas de masque net du sujet.',
  wordBar: 'Outils de lettrage',
  barSmaller: 'Texte plus petit',
  barLarger: 'Texte plus grand',
  script: 'Script et sous-titres',
  scriptText: 'Script ou dialogue',
  scriptSample: 'ANNA: Où sommes-nous ?\nBEN: On y est presque.\n\nSFX: Plouf',
  scriptHelp:
    'Une ligne par bulle, précédée de NOM:. Une ligne vide passe à la case suivante, une ligne comme CASE 3 à cette case.',
  putScript: 'Créer des bulles',
  soundsAsEffects: 'Sons en effets',
  scriptLaid: (n: number) => (n < 2 ? `${n} texte a été mis sur les pages.` : `${n} textes ont été mis sur les pages.`),
  speechSpread: (shown: number, total: number, unplaced: number, left: number) =>
    [
      `${shown} lignes sur ${total} ont été placées ; ${total - shown} n’ont pas trouvé de place.`,
      ...(unplaced > 0 ? [`${unplaced} ${unplaced === 1 ? 'est' : 'sont'} dans la liste des textes non placés.`] : []),
      ...(left > 0 ? [left === 1 ? '1 a été laissée de côté.' : `${left} ont été laissées de côté.`] : []),
    ].join(' '),
  scriptNoPage: 'il n’y a pas encore de page. Ajoutez d’abord des photos.',
  scriptEmpty: 'il n’y a aucun dialogue.',
  scriptOffered: (names: string) => `${names} est peut-être un script. Il n’a pas été mis sur les pages.`,
  scriptFailed: (why: string) => `Le script n’a pas été mis sur la page : ${why}`,
  subtitlesLaid: (shown: number, waiting: number, homeless: number) =>
    [
      shown < 2 ? `${shown} texte a été mis sur les pages.` : `${shown} textes ont été mis sur les pages.`,
      ...(waiting > 0
        ? [`${waiting} ${waiting < 2 ? 'attend' : 'attendent'} des images qu’aucune page ne montre.`]
        : []),
      ...(homeless > 0
        ? [`${homeless} n’${homeless < 2 ? 'a' : 'ont'} pas trouvé d’image proche avec de la place.`]
        : []),
    ].join(' '),
  subtitlesThere: 'tous ses sous-titres sont déjà là.',
  subtitlesSkipped: (n: number, why: readonly string[]) =>
    `${n < 2 ? 'un sous-titre a été ignoré' : `${n} sous-titres ont été ignorés`} : ${why.join(' ')}`,
  textGuessed: (encoding: string) => `il n’est pas en UTF-8, son texte a donc été lu comme ${encoding}.`,
  textLost: (n: number) => (n === 1 ? '1 caractère n’a pas pu être lu.' : `${n} caractères n’ont pas pu être lus.`),
  changeEncoding: 'Changer l’encodage',
  encodingOf: (name: string) => `Encodage de ${name}`,
  encoding: 'Encodage',
  encodingPreview: 'Aperçu',
  readAgain: 'Relire',
  wordsWaiting: (n: number) => (n < 2 ? `${n} texte non placé` : `${n} textes non placés`),
  wordsWaitingWhy:
    'Un texte revient quand une page montre à nouveau sa photo. Un texte sans photo reste ici jusqu’à ce que vous le placiez sur une page.',
  putWaiting: (text: string) => `Mettre sur cette page : ${text}`,
  dropWaiting: (text: string) => `Écarter : ${text}`,
  dropAllWaiting: 'Tout écarter',
};
