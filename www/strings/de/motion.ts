export const motionStrings = {
  motion: {
    help: 'Spielt die Seiten als Motion-Comic ab: erst die ganze Seite, dann Panel für Panel. Der Dialog erscheint beim Lesen.',
    seconds: 'Sekunden je Panel',
    change: 'Seitenübergang',
    preview: 'Motion-Comic',
    living: 'Panels mit Videobildern animieren',
    larger: 'Jedes animierte Panel macht die Datei um bis zu zwei Megabyte größer.',
    apart: 'Die Panels sind nicht animiert, weil der Stil Motive getrennt zeichnet.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} von ${of}, Seite ${page}, Panel ${panel}` : `${time} von ${of}, Seite ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 Seite' : `${pages} Seiten`}, ${length} mit ${fps} Bildern je Sekunde`,
    planning: 'die Seiten werden geplant …',
    failed: (why: string) => `Der Motion-Comic konnte nicht erstellt werden: ${why}`,
    making: (percent: string) => `Der Motion-Comic wird erstellt, ${percent}`,
    saved: 'Der Motion-Comic wurde gespeichert.',
  },
};
