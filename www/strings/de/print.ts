/** Worte des Drucks: Bogen, Beschnitt, Druckplatten und die Prüfung davor. */

export const printStrings = {
  print: {
    moreSizes: 'Weitere Größen',
    purpose: {
      paper: 'Papier',
      book: 'Bücher',
      screen: 'Bildschirme',
    },
    showSafe: 'Sicheren Bereich zeigen',
    safeHelp: 'Alles innerhalb dieser Linie wird nicht abgeschnitten. Die Linie wird nicht exportiert.',
    bleed: 'Beschnitt',
    bleeds: {
      none: 'Keiner',
      mm3: '3 mm',
      mm5: '5 mm',
      inch: '1/8 Zoll',
    },
    bleedHelp:
      'Panels am Seitenrand reichen in den Anschnitt, damit nach dem Schneiden kein weißer Rand bleibt. Mit Seitenrand hat der Anschnitt die Papierfarbe.',
    marks: 'Schnittmarken',
    sheets: 'Bogen',
    impositions: {
      none: 'Eine Seite je Blatt',
      booklet: 'Heft zum Falten und Klammern',
      zine: 'Mini-Zine, acht Seiten aus einem Blatt',
      twoUp: 'Zwei Seiten je Blatt, zum Auseinanderschneiden',
      spreads: 'Doppelseiten',
    },
    booklet: 'Beidseitig drucken, an der kurzen Kante gewendet. Einmal falten und durch den Falz klammern.',
    zine: 'Einseitig drucken. In Achtel falten, die Mitte am Falz einschneiden, zusammenschieben.',
    twoUp: 'Drucken, dann zwischen den Seiten schneiden.',
    spreads: 'Die erste Seite allein, dann je zwei wie im offenen Buch.',
    blanks: (n: number) => `${n === 1 ? 'Eine Seite bleibt' : `${n} Seiten bleiben`} leer.`,
    paperSize: 'Papier',
    papers: {
      none: 'So groß wie die Seiten',
      a4: 'A4',
      a3: 'A3',
      letter: 'Letter',
      tabloid: 'Tabloid',
    },
    plates: 'Sonderfarben-Auszüge (Riso, Siebdruck)',
    platesHelp: 'Eine graue PDF-Datei je Druckfarbe, zusammen in einem ZIP.',
    inks: {
      red: 'Rot',
      blue: 'Blau',
      pink: 'Pink',
      teal: 'Petrol',
      orange: 'Orange',
      navy: 'Marineblau',
      coral: 'Koralle',
      green: 'Grün',
      yellow: 'Gelb',
      cyan: 'Cyan',
      magenta: 'Magenta',
      violet: 'Violett',
      black: 'Schwarz',
    },
    coarse: (n: number, dpi: number) =>
      `${n === 1 ? 'Ein Bild hat' : `${n} Bilder haben`} bei dieser Größe weniger als ${dpi} dpi; im Druck wirkt das leicht unscharf:`,
    coarsePanel: (n: number, dpi: number) => `Bild ${n}: ${dpi} dpi`,
    coarseOn: (page: number, n: number, dpi: number) => `Seite ${page}, Bild ${n}: ${dpi} dpi`,
    coarseMore: (n: number) => `und ${n} weitere`,
    enlarge: 'Fotos mit niedriger Auflösung hochskalieren',
    enlargeHelp: (n: number) =>
      n === 1
        ? 'Das Foto dieses Panels wird mit schärferen Kanten hochskaliert. Dabei kommen keine Einzelheiten dazu.'
        : `Die Fotos dieser ${n} Panels werden mit schärferen Kanten hochskaliert. Dabei kommen keine Einzelheiten dazu.`,
    coarseMark: (dpi: number) => `${dpi} dpi`,
    coarseHelp: 'Zeige das Foto kleiner oder weniger beschnitten, oder nimm ein größeres.',
    coarseHide: 'Auflösungswarnungen ausblenden',
  },
};
