export const offlineStrings = {
  newVersion: 'Hay una versión nueva.',
  reload: 'Recargar',
  notReloaded: 'La página no se ha cargado otra vez, porque tu trabajo no está guardado.',
  install: 'Instalar',
  installHelp: 'Abre Inkpanel en su propia ventana, también sin conexión',
  sharedLost:
    'Lo compartido no ha llegado: quizá el almacenamiento de este navegador esté lleno. Añade las fotos aquí.',
  launchFailed: (name: string) => `No se pudo abrir ${name}. Añádelo aquí.`,
  noDetectorOffline:
    'Sin conexión aún no se pueden buscar caras, así que las fotos se recortan por contraste hasta que la haya.',
};
