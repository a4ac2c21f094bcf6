import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'der Speicher dieses Browsers ist voll',
  refused: 'dieser Browser blockiert hier den Speicher für Websites',
};

export const storageStrings = {
  // Saving
  saveState: {
    empty: '',
    saving: 'Speichert…',
    saved: 'Gespeichert',
    missing: 'Teilweise gespeichert',
    full: 'Nicht gespeichert',
    refused: 'Nicht gespeichert',
    failed: 'Nicht gespeichert',
  },
  savingCount: (done: number, total: number) => `Speichert ${done} von ${total}`,
  saveHelp: 'Deine Arbeit wird in diesem Browser gespeichert, auf diesem Gerät',
  notSaved: (why: string, message: string) =>
    `Deine Arbeit ist nicht gespeichert: ${TROUBLE[why] ?? message.replace(/\.$/, '')}. Sie geht verloren, wenn du diesen Tab schließt.`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)}: nicht gespeichert, die ${names.length === 1 ? 'Datei ist' : 'Dateien sind'} nicht mehr lesbar. Alles andere ist gespeichert.`,
  photosNotHere: (names: readonly string[], of: number) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} von ${of} Fotos` : one ? 'Das Foto' : `Alle ${of} Fotos`;
    return `${which} ${one ? 'ist' : 'sind'} nicht in diesem Browser: ${some(names)}. Wähle ${one ? 'es' : 'sie'} oder lass ${one ? 'es' : 'sie'} hier fallen: Jedes kommt an seinen Platz zurück.`;
  },
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)}: nicht mehr in diesem Browser, die Einzelbilder schon. Um andere zu nehmen, füge das Video noch einmal hinzu.`,
  photosNeverSaved: (names: readonly string[]) =>
    `Die App wurde geschlossen, bevor ${some(names)} gespeichert ${names.length === 1 ? 'war' : 'waren'}. Wähle ${names.length === 1 ? 'die Datei' : 'die Dateien'} noch einmal.`,
  saveAgain: 'Noch einmal speichern',
  goOnWithout: 'Ohne sie weiter',
  saveToFile: 'In Datei speichern',
  conflict: 'Ein anderer Tab hat dieses Projekt geändert. Dieser Tab macht mit einer Kopie weiter.',

  // Projects
  projects: 'Projekte',
  projectName: 'Projektname',
  untitled: 'Unbenannt',
  newProject: 'Neues Projekt',
  openProject: 'Projektdatei öffnen',
  saveProject: 'Projektdatei speichern',
  projectFile: 'Projektdatei',
  openNamed: (name: string) => `${name} öffnen`,
  duplicateNamed: (name: string) => `${name} duplizieren`,
  deleteNamed: (name: string) => `${name} löschen`,
  renameNamed: (name: string) => `${name} umbenennen`,
  newNameOf: (name: string) => `Neuer Name von ${name}`,
  sampleAlbum: 'Beispielalbum',
  openNow: 'Gerade offen',
  projectAbout: (photos: number, when: string) =>
    `${photos === 1 ? '1 Foto' : `${photos} Fotos`}${when && `, ${when}`}`,
  noProjects: 'Deine Arbeit wird hier automatisch gespeichert.',
  projectDeleted: (name: string) => `${name} wurde gelöscht.`,
  bringBack: 'Wiederherstellen',
  projectNotOpened: (why: string) => `Das Projekt ließ sich nicht öffnen: ${why}`,
  projectFileNotOpened: (name: string, why: string) => `${name} ließ sich nicht öffnen: ${why}`,
  projectNotSaved: (why: string) => `Das Projekt ließ sich nicht als Datei speichern: ${why}`,
  projectReasons: {
    'damaged-project': 'Es ist beschädigt oder kein Projekt von Inkpanel. Deine Seite wurde nicht geändert.',
    'too-large-project': 'Es überschreitet die Grenzen eines Projekts. Deine Seite wurde nicht geändert.',
    'silent-project':
      'Das Lesen der Datei wurde nach einer Minute abgebrochen. Prüfe das Laufwerk und versuche es noch einmal.',
    'newer-project':
      'Es wurde mit einer neueren Version von Inkpanel gespeichert. Lade diesen Tab neu, um zu aktualisieren.',
    'not-saved': 'Deine Arbeit ist nicht gespeichert. Speichere sie erst in eine Datei (Projektdatei speichern).',
    'missing-project': 'Es wurde gelöscht.',
    'no-storage': 'Dieser Browser blockiert hier den Speicher für Websites.',
    'too-large': 'Die Datei würde größer als 4 GB.',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `${others.length + 1} Projekte wurden geöffnet, jedes für sich. ${shown} ist auf der Seite; ${others.length === 1 ? `${others[0]} ist` : `${others.length} weitere sind`} unter Projekte.`,
  photosWithProject: (n: number, name: string) =>
    n === 1
      ? `Das Foto, das dabei war, wurde zu ${name} hinzugefügt.`
      : `Die ${n} Fotos, die dabei waren, wurden zu ${name} hinzugefügt.`,
  projectBroken: (name: string, why: string) => `${name} lässt sich nicht zeigen: ${why}.`,
  brokenReasons: {
    'damaged-project': 'ein Teil ist beschädigt',
    'too-large-project': 'es überschreitet die Grenzen eines Projekts',
    'newer-project':
      'es wurde mit einer neueren Version von Inkpanel gespeichert. Lade diesen Tab neu, um zu aktualisieren',
  } as Record<string, string>,
  brokenOtherwise: 'ein Teil lässt sich nicht zeichnen',
  brokenKept: 'Das Projekt und seine Fotos sind unverändert.',
  partsLeftOut: (name: string, n: number) =>
    `${name} ist offen, ohne ${n === 1 ? 'einen Teil, der sich nicht lesen ließ' : `${n} Teile, die sich nicht lesen ließen`}.`,
  openAnother: 'Anderes öffnen',
  saveAsFile: 'Als Datei speichern',
  goBack: 'Letzte gute Version wiederherstellen',
  noGoodState: 'Es gibt keine frühere Version zum Wiederherstellen.',
  wentBack: (name: string) => `Die letzte gute Version von ${name} wurde wiederhergestellt.`,
  openingProject: (name: string) => `${name} wird geöffnet`,
  openingLast: 'Dein Projekt wird geöffnet',
  openElsewhere: (name: string) => `${name} ist in einem anderen Tab offen.`,
  opensWhenFree: 'Es öffnet sich hier, wenn du den anderen Tab schließt.',
  openCopy: 'Kopie öffnen',

  // Pages shown
  pagesShown: 'Seitenverlauf',
  pagesShownAt: (n: number, of: number) => `Seitenverlauf, ${n}/${of}`,
  pageNumber: (n: number) => `Seite ${n}`,
  versionFrom: (n: number) => `aus Version ${n}`,
  favouritePage: 'Lieblingsseite',
  favouritePages: 'Nur Favoriten',
  versionNumber: (n: number) => `Version ${n}`,
  compareShort: 'Vergleichen',
  comparePage: (n: number) => `Version ${n} vergleichen`,
  comparedAll: 'Alle Versionen zeigen',
  compareSecond: 'Wähle die zweite Version zum Vergleichen',
  noFavouritePages: 'Noch keine Favoriten. Drücke das Herz auf einer Seite, die dir gefällt.',
};
