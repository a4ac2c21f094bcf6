export const offlineStrings = {
  newVersion: 'Eine neue Version ist da.',
  reload: 'Neu laden',
  notReloaded: 'Die Seite wurde nicht neu geladen, da deine Arbeit nicht gespeichert ist.',
  install: 'Installieren',
  installHelp: 'Öffnet Inkpanel in einem eigenen Fenster, auch ohne Verbindung',
  sharedLost: 'Das Geteilte kam nicht an: Vielleicht ist der Speicher dieses Browsers voll. Füge die Fotos hier hinzu.',
  launchFailed: (name: string) => `${name} ließ sich nicht öffnen. Füge die Datei hier hinzu.`,
  noDetectorOffline:
    'Ohne Verbindung lassen sich Gesichter noch nicht finden. Bis dahin werden Fotos nach Kontrast zugeschnitten.',
};
