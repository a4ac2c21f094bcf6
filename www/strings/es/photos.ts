export const photoStrings = {
  photos: 'Fotos',
  usePhoto: (name: string) => `Usar ${name}`,
  pickPhoto: (name: string) => `Elegir ${name}`,
  pickLong: 'Pulsa para ponerla en la viñeta elegida o en la próxima que pulses; o arrástrala a una viñeta',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `en la viñeta ${panel}` : `en la página ${page}, viñeta ${panel}`,
  youLeftOut: 'La has excluido',
  leftOut: (name: string) => `${name} se ha excluido.`,
  starPhoto: (name: string) => `Destacar ${name}`,
  starLong: 'Amplía la viñeta de esta foto y la muestra grande en cada mezcla',
  starLocked: 'Foto destacada. El diseño o la viñeta está bloqueada, así que conserva su tamaño.',
  starKeepsSize: 'Foto destacada. Este diseño no tiene espacio para una viñeta mayor; al barajar, la foto sale grande.',
  removePhoto: (name: string) => `Quitar ${name}`,
  photoMissing: 'Falta',
  addPhotos: 'Añadir fotos',
  kept: 'En uso',
  unseen: {
    waits: 'Aún no ha salido',
    text: 'No sale: parece una página de texto',
    small: 'No sale: tiene muy pocos píxeles',
  },
  setAside: 'Excluidas',
  setAsideWhy: 'Parecidas y desenfocadas. Marca una para usarla.',
  choice: 'Selección de fotos',
  alike: 'Excluir las parecidas',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, casi idénticas`
      : bits < 11
        ? `${bits}, la misma imagen`
        : bits < 14
          ? `${bits}, muy parecidas`
          : `${bits}, algo parecidas`,
  alikeKept: (kept: number, all: number) => `${kept} de ${all} en uso`,
  order: 'Orden',
  orders: { time: 'Fecha de la toma', name: 'Nombre de archivo' },
  stackWhy: 'Estas fotos se parecen. Se usa la marcada; marca más o usa otra.',
  stackOf: (count: number) => `${count} parecidas`,
  openStack: (count: number, name: string) => `Mostrar las ${count} fotos parecidas a ${name}`,
  take: 'Usar',
  takeInstead: (name: string) => `Usar ${name} en su lugar`,
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
  frames: 'Fotogramas del vídeo',
  lookingThrough: (name: string, percent: string) => `Analizando ${name}, ${percent}`,
  takeFrames: 'Usar estos fotogramas',

  showSubjects: 'Mostrar lo detectado',
  finding: (done: number, total: number) => `Detectando caras y objetos: ${done} de ${total} fotos`,
  masking: (done: number, total: number) => `Detectando motivos: ${done} de ${total} fotos`,
  stopMasking: 'Detener la detección de motivos',
  goOnMasking: 'Reanudar la detección de motivos',
  noDetector: 'La detección de caras no está disponible aquí, así que las fotos se recortan por contraste.',
};
