export const offlineStrings = {
  newVersion: 'Eine neue Version ist da.',
  reload: 'Neu laden',
  notReloaded: 'Die App wurde nicht neu geladen, da deine Arbeit nicht gespeichert ist.',
  install: 'Installieren',
  installHelp: 'Öffnet Inkpanel in einem eigenen Fenster, auch ohne Verbindung',
  sharedLost:
    'Die geteilten Dateien kamen nicht an. Vielleicht ist der Speicher dieses Browsers voll. Füge die Fotos hier hinzu.',
  launchFailed: (name: string) => `${name} ließ sich nicht öffnen. Füge die Datei hier hinzu.`,
  noDetectorOffline:
    'Die Gesichtserkennung muss einmal geladen werden. Bis du online bist, werden Fotos nach Kontrast zugeschnitten.',
};
