const photos = (n: number) => (n === 1 ? '1 Foto' : `${n} Fotos`);
const pages = (n: number) => (n === 1 ? '1 Seite' : `${n} Seiten`);

export const bookStrings = {
  book: {
    name: 'Seiten',
    page: (n: number, of: number) => `Seite ${n} von ${of}`,
    add: 'Seite hinzufügen',
    addHelp: 'Eine Seite nach dieser einfügen',
    addMore: (left: number) => `Eine Seite hinzufügen: ${photos(left)} noch auf keiner Seite`,
    tools: 'Seitenwerkzeuge',
    remove: 'Seite entfernen',
    turnBack: 'Vorherige Seite',
    turnOn: 'Nächste Seite',
    earlier: 'Seite nach vorn',
    later: 'Seite nach hinten',
    make: 'Buch erstellen',
    makeHelp: (n: number) => `Titelseite, Kapitel nach Tagen, Texte und Seitenzahlen, mit deinen ${n} Fotos`,
    makeChapters: 'Buch erstellen, jeder Tag in eigenem Stil',
    makeChaptersHelp: 'Wie „Buch erstellen“, mit einem anderen Stil für jeden Tag',
    made: (n: number) => `Dein Buch hat ${pages(n)}.`,
    looking: 'Deine Fotos werden angesehen …',
    making: (done: number, of: number) => `Seite ${done + 1} von ${of} …`,
    spreadAlbum: 'Seiten aus allen Fotos machen',
    spreadHelp: (n: number) => `Mehrere Seiten mit allen ${n} Fotos, in ihrer Reihenfolge`,
    spreadAsk: 'Die neuen Seiten ersetzen deine Seiten, auch was du von Hand geändert hast.',
    spreadYes: 'Seiten ersetzen',
    styleAll: 'Diesen Stil auf allen Seiten',
    left: (n: number) => `${photos(n)} auf keiner Seite`,
    reading: 'Die Fotos werden noch gelesen.',
    removed: (n: number) => `Seite ${n} wurde entfernt.`,
    spread: (n: number, on: number) => `${photos(n)} auf ${pages(on)}.`,
    repeats: (n: number) =>
      n === 1
        ? 'Es gibt nicht genug unbenutzte Fotos. Diese Seite wiederholt 1 Foto.'
        : `Es gibt nicht genug unbenutzte Fotos. Diese Seite wiederholt ${n} Fotos.`,
    takeBack: 'Seiten wiederherstellen',
    dragHelp: 'Zum Verschieben ziehen, oder Alt mit einer Pfeiltaste',
  },
  version: (n: number, of: number) => `Version ${n} von ${of} dieser Seite: alle Versionen zeigen`,
  previousHelp: 'Die vorherige Version dieser Seite zeigen',
  nextHelp: 'Die nächste Version dieser Seite zeigen',
};
