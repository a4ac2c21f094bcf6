export const motionStrings = {
  motion: {
    help: 'Les pages du storyboard en film : chacune se voit en entier, puis case par case, et ce qui est dit apparaît au fil de la lecture.',
    seconds: 'Secondes par case',
    change: 'D’une page à l’autre',
    preview: 'Page animée',
    living: 'Les cases tirées de films bougent',
    larger: 'Chaque case ajoute jusqu’à deux mégaoctets au fichier.',
    apart: 'Les cases restent fixes : le style dessine les figures à part.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} sur ${of}, page ${page}, case ${panel}` : `${time} sur ${of}, page ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 page' : `${pages} pages`}, ${length} à ${fps} images par seconde`,
    planning: 'mise en place des pages…',
    failed: (why: string) => `La page animée ne peut pas être préparée : ${why}`,
    making: (percent: string) => `Création de la page animée, ${percent}`,
    saved: 'La page animée a été enregistrée.',
  },
};
