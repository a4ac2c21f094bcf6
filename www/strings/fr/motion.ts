export const motionStrings = {
  motion: {
    help: 'Lit les pages comme une BD animée : d’abord la page entière, puis case par case. Le dialogue apparaît au fil de la lecture.',
    seconds: 'Secondes par case',
    change: 'Transition de page',
    preview: 'BD animée',
    living: 'Animer les cases avec les images de la vidéo',
    larger: 'Chaque case animée ajoute jusqu’à deux mégaoctets au fichier.',
    apart: 'Les cases ne sont pas animées, car le style dessine les sujets à part.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} sur ${of}, page ${page}, case ${panel}` : `${time} sur ${of}, page ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 page' : `${pages} pages`}, ${length} à ${fps} images par seconde`,
    planning: 'planification des pages…',
    failed: (why: string) => `La BD animée n’a pas pu être créée : ${why}`,
    making: (percent: string) => `Création de la BD animée, ${percent}`,
    saved: 'La BD animée a été enregistrée.',
  },
};
