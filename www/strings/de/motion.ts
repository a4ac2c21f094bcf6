export const motionStrings = {
  motion: {
    help: 'Die Seiten des Storyboards als Film: jede erst im Ganzen, dann Bild für Bild, und was gesagt wird, erscheint beim Lesen.',
    seconds: 'Sekunden je Bild',
    change: 'Von Seite zu Seite',
    preview: 'Bewegte Seite',
    living: 'Bilder aus Filmen bewegen sich',
    larger: 'Jedes Bild macht die Datei um bis zu zwei Megabyte größer.',
    apart: 'Die Bilder stehen still: Der Stil zeichnet Figuren für sich.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} von ${of}, Seite ${page}, Bild ${panel}` : `${time} von ${of}, Seite ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 Seite' : `${pages} Seiten`}, ${length} mit ${fps} Bildern je Sekunde`,
    planning: 'die Seiten werden gereiht …',
    failed: (why: string) => `Die bewegte Seite lässt sich nicht zusammenstellen: ${why}`,
    making: (percent: string) => `Die bewegte Seite entsteht, ${percent}`,
    saved: 'Die bewegte Seite wurde gespeichert.',
  },
};
