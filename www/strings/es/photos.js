// @ts-check
export const photoStrings = {
  photos: 'Fotos',
  usePhoto: (/** @type {string} */ name) => `Usar ${name}`,
  removePhoto: (/** @type {string} */ name) => `Quitar ${name}`,
  photoMissing: 'Falta',
  addPhotos: 'Añadir fotos',
  kept: 'En la mesa',
  setAside: 'Apartadas',
  choice: 'Selección de fotos',
  alike: 'Apartar las parecidas',
  alikeValue: (/** @type {number} */ bits) => (
    bits < 7 ? `${bits}, casi idénticas` : bits < 11 ? `${bits}, la misma imagen` : bits < 14 ? `${bits}, muy parecidas` : `${bits}, algo parecidas`
  ),
  alikeKept: (/** @type {number} */ kept, /** @type {number} */ all) => `Quedan ${kept} de ${all}`,
  order: 'Orden',
  orders: { time: 'Por fecha de la toma', name: 'Por nombre de archivo' },
  stackOf: (/** @type {number} */ count) => `${count} parecidas`,
  openStack: (/** @type {number} */ count, /** @type {string} */ name) => `Mostrar las ${count} fotos parecidas a ${name}`,
  take: 'Tomar',
  takeInstead: (/** @type {string} */ name) => `Tomar ${name} en su lugar`,
  /** @param {{ title: string, author: string, licence: string }} sample */
  credit: ({ title, author, licence }) => `${title}, de ${author} (${licence})`,
  photoCount: (/** @type {number} */ used, /** @type {number} */ all) => (used === all ? `${all}` : `${used} de ${all}`),
  reading: (/** @type {number} */ done, /** @type {number} */ total) => `Leyendo fotos, ${done} de ${total}`,
  cancelReading: 'Dejar de leer',

  // Videos
  videos: 'Vídeos',
  videoFrames: (/** @type {number} */ count) => (count === 1 ? '1 fotograma' : `${count} fotogramas`),
  trimStart: 'Inicio',
  trimEnd: 'Fin',
  frames: 'Fotogramas',
  takeFrames: 'Tomar estos fotogramas',

  showSubjects: 'Mostrar lo detectado',
  finding: (/** @type {number} */ done, /** @type {number} */ total) => `Caras ${done}/${total}`,
  findingLong: (/** @type {number} */ done, /** @type {number} */ total) => `Buscando caras y objetos: ${done} de ${total} fotos`,
  noDetector: 'Aquí no se pueden buscar caras, así que las fotos se recortan por contraste.',
};
