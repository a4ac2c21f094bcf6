// @ts-check
export const offlineStrings = {
  newVersion: 'Hay una versión nueva.',
  reload: 'Recargar',
  notReloaded: 'La página no se ha recargado, porque tu trabajo no está guardado.',
  install: 'Instalar',
  installHelp: 'Abre Inkpanel en su propia ventana, también sin conexión',
  sharedLost: 'Lo que se compartió no ha llegado: puede que el almacenamiento de este navegador esté lleno. Añade las fotos aquí.',
  launchFailed: (/** @type {string} */ name) => `No se pudo abrir ${name}. Añádelo aquí.`,
  noDetectorOffline: 'Sin conexión aún no se pueden encontrar caras, así que las fotos se recortan por contraste hasta que haya conexión.',
};
