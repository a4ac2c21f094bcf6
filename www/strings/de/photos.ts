export const photoStrings = {
  photos: 'Fotos',
  usePhoto: (name: string) => `${name} verwenden`,
  pickPhoto: (name: string) => `${name} auswählen`,
  pickLong:
    'Klicken setzt es ins ausgewählte Panel oder in das, auf das du als Nächstes klickst; oder zieh es auf ein Panel',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `in Panel ${panel}` : `auf Seite ${page}, Panel ${panel}`,
  youLeftOut: 'Von dir ausgeschlossen',
  leftOut: (name: string) => `${name} wurde ausgeschlossen.`,
  starPhoto: (name: string) => `${name} hervorheben`,
  starLong: 'Das Panel dieses Fotos vergrößern und das Foto bei jedem Mischen groß zeigen',
  starLocked: 'Foto mit Stern. Layout oder Panel ist gesperrt, darum behält das Panel seine Größe.',
  starKeepsSize: 'Foto mit Stern. Dieses Layout hat keinen Platz für ein größeres Panel; Mischen zeigt das Foto groß.',
  removePhoto: (name: string) => `${name} entfernen`,
  photoMissing: 'Fehlt',
  addPhotos: 'Fotos hinzufügen',
  kept: 'In Gebrauch',
  unseen: {
    waits: 'Noch nicht gezeigt',
    text: 'Nicht gezeigt: sieht wie eine Textseite aus',
    small: 'Nicht gezeigt: zu wenige Pixel',
  },
  setAside: 'Ausgeschlossen',
  setAsideWhy: 'Ähnliche und unscharfe Fotos. Hake eines an, um es zu verwenden.',
  choice: 'Auswahl der Fotos',
  alike: 'Ähnliche Fotos ausschließen',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, fast gleich`
      : bits < 11
        ? `${bits}, dasselbe Bild`
        : bits < 14
          ? `${bits}, sehr ähnlich`
          : `${bits}, etwas ähnlich`,
  alikeKept: (kept: number, all: number) => `${kept} von ${all} in Gebrauch`,
  order: 'Reihenfolge',
  orders: { time: 'Aufnahmezeit', name: 'Dateiname' },
  stackWhy: 'Sie sehen sich ähnlich. Das angehakte wird verwendet; hake mehr an oder nimm ein anderes.',
  stackOf: (count: number) => `${count} ähnliche`,
  openStack: (count: number, name: string) => `Die ${count} Fotos wie ${name} zeigen`,
  take: 'Nehmen',
  takeInstead: (name: string) => `Stattdessen ${name} nehmen`,
  credit: ({ title, author, licence }: { title: string; author: string; licence: string }) =>
    `${title}, von ${author} (${licence})`,
  photoCount: (used: number, all: number) => (used === all ? `${all}` : `${used} von ${all}`),
  reading: (done: number, total: number) => `Fotos werden gelesen, ${done} von ${total}`,
  cancelReading: 'Lesen abbrechen',

  // Videos
  videos: 'Videos',
  videoFrames: (count: number) => (count === 1 ? '1 Einzelbild' : `${count} Einzelbilder`),
  trimStart: 'Anfang',
  trimEnd: 'Ende',
  frames: 'Einzelbilder aus dem Video',
  lookingThrough: (name: string, percent: string) => `${name} wird analysiert, ${percent}`,
  takeFrames: 'Diese Einzelbilder nehmen',

  showSubjects: 'Gefundenes zeigen',
  finding: (done: number, total: number) => `Gesichter und Objekte werden erkannt: ${done} von ${total} Fotos`,
  masking: (done: number, total: number) => `Motive werden erkannt: ${done} von ${total} Fotos`,
  stopMasking: 'Motiverkennung anhalten',
  goOnMasking: 'Motiverkennung fortsetzen',
  noDetector: 'Die Gesichtserkennung ist hier nicht verfügbar. Daher werden Fotos nach Kontrast zugeschnitten.',
};
