export const photoStrings = {
  photos: 'Fotos',
  usePhoto: (name: string) => `Usar ${name}`,
  pickPhoto: (name: string) => `Elegir ${name}`,
  pickLong: 'Pulsa para ponerla en la viñeta elegida o en la próxima que pulses; o arrástrala a una viñeta',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `en la viñeta ${panel}` : `en la página ${page}, viñeta ${panel}`,
  youLeftOut: 'La has dejado fuera',
  leftOut: (name: string) => `${name} queda fuera.`,
  starPhoto: (name: string) => `Destacar ${name}`,
  starLong: 'Mostrarla grande, aquí y al barajar',
  removePhoto: (name: string) => `Quitar ${name}`,
  photoMissing: 'Falta',
  addPhotos: 'Añadir fotos',
  kept: 'En la mesa',
  setAside: 'Apartadas',
  setAsideWhy: 'Parecidas y desenfocadas. Marca una para usarla.',
  choice: 'Selección de fotos',
  alike: 'Apartar las parecidas',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, casi idénticas`
      : bits < 11
        ? `${bits}, la misma imagen`
        : bits < 14
          ? `${bits}, muy parecidas`
          : `${bits}, algo parecidas`,
  alikeKept: (kept: number, all: number) => `Quedan ${kept} de ${all}`,
  order: 'Orden',
  orders: { time: 'Fecha de la toma', name: 'Nombre de archivo' },
  stackWhy: 'Se parecen. Se usa la marcada; marca más o toma otra.',
  stackOf: (count: number) => `${count} parecidas`,
  openStack: (count: number, name: string) => `Mostrar las ${count} fotos parecidas a ${name}`,
  take: 'Tomar',
  takeInstead: (name: string) => `Tomar ${name} en su lugar`,
  credit: ({ title, author, licence }: { title: string; author: string; licence: string }) =>
    `${title}, de ${author} (${licence})`,
  photoCount: (used: number, all: number) => (used === all ? `${all}` : `${used} de ${all}`),
  reading: (done: number, total: number) => `Leyendo fotos, ${done} de ${total}`,
  cancelReading: 'Dejar de leer',

  // Videos
  videos: 'Vídeos',
  videoFrames: (count: number) => (count === 1 ? '1 fotograma' : `${count} fotogramas`),
  trimStart: 'Inicio',
  trimEnd: 'Fin',
  frames: 'Fotogramas de la película',
  lookingThrough: (name: string, percent: string) => `Recorriendo ${name}, ${percent}`,
  takeFrames: 'Tomar estos fotogramas',

  showSubjects: 'Mostrar lo detectado',
  finding: (done: number, total: number) => `Buscando caras y objetos: ${done} de ${total} fotos`,
  masking: (done: number, total: number) => `Buscando figuras: ${done} de ${total} fotos`,
  stopMasking: 'Dejar de buscar figuras',
  goOnMasking: 'Seguir buscando figuras',
  noDetector: 'Aquí no se pueden buscar caras, así que las fotos se recortan por contraste.',
};
