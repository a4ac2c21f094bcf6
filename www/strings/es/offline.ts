export const offlineStrings = {
  newVersion: 'Hay una versión nueva.',
  reload: 'Recargar',
  notReloaded: 'La aplicación no se ha recargado, porque tu trabajo no está guardado.',
  install: 'Instalar',
  installHelp: 'Abre Inkpanel en su propia ventana, también sin conexión',
  sharedLost:
    'Los archivos compartidos no han llegado. Quizá el almacenamiento de este navegador esté lleno. Añade las fotos aquí.',
  launchFailed: (name: string) => `No se pudo abrir ${name}. Añádelo aquí.`,
  noDetectorOffline:
    'La detección de caras debe descargarse una vez. Hasta que tengas conexión, las fotos se recortan por contraste.',
};
