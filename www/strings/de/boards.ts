/** Strings of the storyboard: shot list, sheets, import and export. */

export const boardsStrings = {
  boards: {
    seen: 'Ansicht',
    comic: 'Comic',
    board: 'Storyboard',
    sheets: 'Storyboard-Blätter',
    shots: 'Einstellungen',
    picture: 'Bild',
    order: 'Reihenfolge',
    columns: {
      scene: 'Szene',
      number: 'Einstellung',
      length: 'Länge',
      action: 'Handlung',
      dialogue: 'Dialog',
      notes: 'Notizen',
    },
    /** the columns of a list that is saved */
    heading: ['Szene', 'Einstellung', 'Bild', 'Film', 'Timecode', 'Dauer', 'Bilder', 'Handlung', 'Dialog', 'Notizen'],
    /** on the sheets; `{page}` and `{count}` become numbers */
    labels: { scene: 'Szene', dialogue: 'Dialog', notes: 'Notizen', page: 'Blatt {page} von {count}' },
    count: (count: number) => (count === 1 ? '1 Einstellung' : `${count} Einstellungen`),
    shot: (number: string) => `Einstellung ${number}`,
    up: (number: string) => `Einstellung ${number} nach oben`,
    down: (number: string) => `Einstellung ${number} nach unten`,
    help: 'Eingabe geht zur nächsten Einstellung, Tab zum nächsten Feld, Escape verwirft das Getippte. Alt mit den Pfeiltasten verschiebt eine Einstellung. Längen sind Sekunden (2), Sekunden und Bilder (2:12) oder Bilder (36f). Zellen einer Tabelle lassen sich einfügen.',
    followPages: 'Reihenfolge der Seiten',
    dragHelp: 'Ziehen, um sie woanders einzureihen.',
    copy: 'Tabelle kopieren',
    copied: 'Die Liste wurde kopiert. Du kannst sie in eine Tabelle einfügen.',
    newColumn: 'Neue Spalte',
    addColumn: 'Spalte hinzufügen',
    removeColumn: (name: string) => `Spalte ${name} entfernen`,
    noLength: (text: string) =>
      `„${text}“ ist keine Länge: Schreib Sekunden (2), Sekunden und Bilder (2:12) oder Bilder (36f).`,
    pasteLost: (count: number) =>
      count === 1
        ? '1 eingefügte Zelle lag außerhalb der Tabelle und wurde ignoriert.'
        : `${count} eingefügte Zellen lagen außerhalb der Tabelle und wurden ignoriert.`,
    filmBoard: 'Film-Storyboard',
    perSheet: 'Bilder je Blatt',
    aspect: 'Seitenverhältnis',
    rate: 'Bilder je Sekunde',
    beside: 'Text neben den Bildern',
    ruled: 'Arbeitsblatt: Linien zum Schreiben',
    author: 'Von',
    date: 'Datum',
    logo: 'Logo',
    chooseLogo: 'Logo wählen',
    removeLogo: 'Logo entfernen',
    logoFile: 'Bild für das Logo',
    noLogo: (name: string) =>
      `${name} ist kein Bild, das der Browser zeigen kann. Wähle eine PNG-, JPEG-, WebP- oder SVG-Datei.`,
    brokenLogo: 'Das Logo kann nicht gelesen werden. Entferne es oder wähle ein anderes.',
    saveAs: 'Speichern als',
    saveBoard: 'Storyboard speichern',
    ways: { pdf: 'Storyboard, PDF', zip: 'Storyboard, PNG-Dateien in einem ZIP' },
    importFile: 'Drehbuch oder Tabelle laden',
    tooLarge: (name: string) => `${name} ist zu groß für ein Drehbuch oder eine Tabelle.`,
    nothingIn: (name: string) => `Nichts in ${name} passt zu den Einstellungen.`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name}: 1 Einstellung wurde ausgefüllt.` : `${name}: ${count} Einstellungen wurden ausgefüllt.`,
    quoted: (text: string) => `„${text}“`,
    left: (count: number, lines: string) =>
      count === 1
        ? `1 Zeile passt zu keiner Einstellung: ${lines}.`
        : `${count} Zeilen passen zu keiner Einstellung: ${lines}.`,
    cellsLeft: (count: number, cells: string) =>
      count === 1
        ? `1 Zelle wurde ausgelassen oder gekürzt: ${cells}.`
        : `${count} Zellen wurden ausgelassen oder gekürzt: ${cells}.`,
    columnsLeft: (columns: string) => `Für diese Spalten ist im Storyboard kein Platz: ${columns}.`,
    noSheets: (why: string) => `Das Storyboard konnte nicht angelegt werden: ${why}`,
    missing: 'Das Storyboard konnte nicht geladen werden. Prüfe die Verbindung und versuche es noch einmal.',
    sheet: (n: number, of: number) => `Blatt ${n} von ${of}`,
    listSaved: 'Die Liste der Einstellungen wurde gespeichert.',
    listHelp: 'Alle Einstellungen des Albums mit ihren Angaben, in der Reihenfolge des Storyboards.',
  },
};
