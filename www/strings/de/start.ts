export const startStrings = {
  lead: ['Fotos rein.', 'Comic raus.'],
  leadMore: 'Inkpanel wählt aus, schneidet zu, tuscht und ordnet an. Misch, bis es dir gefällt.',
  chooseFiles: 'Fotos oder Video wählen',
  filesLabel: 'Fotos oder Video',
  trySamples: 'Beispielalbum ausprobieren',
  startPages: 'Drei Comicseiten aus dem Beispielalbum',
  recentProjects: 'Letzte Projekte',
  privacy: 'Nichts verlässt dieses Gerät.',
  dropHere: 'Loslassen, um deine Fotos hinzuzufügen',
  framed: 'Zum Schutz vor Clickjacking läuft Inkpanel nicht innerhalb anderer Websites.',
  openInTab: 'Inkpanel in einem neuen Tab öffnen',
  starting: 'Inkpanel wird gestartet',
};
