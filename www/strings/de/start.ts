export const startStrings = {
  lead: ['Fotos rein.', 'Comic raus.'],
  leadMore: 'Inkpanel wählt aus, schneidet zu, tuscht und ordnet an. Misch, bis es dir gefällt.',
  chooseFiles: 'Fotos oder Video wählen',
  filesLabel: 'Fotos oder Video',
  trySamples: 'Beispielalbum ausprobieren',
  privacy: 'Nichts verlässt dieses Gerät.',
  dropHere: 'Loslassen, um deine Fotos hinzuzufügen',
  framed:
    'Eine andere Website zeigt Inkpanel in ihrer eigenen Seite. Dort läuft es nicht, damit niemand dich drücken lässt, was du nicht siehst.',
  openInTab: 'Inkpanel in einem eigenen Tab öffnen',
  starting: 'Die Tusche wird angerührt',
};
