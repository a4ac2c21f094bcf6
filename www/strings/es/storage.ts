import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'el almacenamiento de este navegador está lleno',
  refused: 'este navegador bloquea aquí el almacenamiento de sitios',
};

export const storageStrings = {
  // Saving
  saveState: {
    empty: '',
    saving: 'Guardando…',
    saved: 'Guardado',
    missing: 'Guardado en parte',
    full: 'Sin guardar',
    refused: 'Sin guardar',
    failed: 'Sin guardar',
  },
  savingCount: (done: number, total: number) => `Guardando ${done} de ${total}`,
  saveHelp: 'El trabajo se guarda en este navegador, en este dispositivo',
  notSaved: (why: string, message: string) =>
    `Tu trabajo no está guardado: ${TROUBLE[why] ?? message.replace(/\.$/, '')}. Se perderá si cierras esta pestaña.`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)}: ${names.length === 1 ? 'sin guardar, su archivo ya no se puede leer' : 'sin guardar, sus archivos ya no se pueden leer'}. Todo lo demás está guardado.`,
  photosNotHere: (names: readonly string[], of: number) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} de ${of} fotos` : one ? 'La foto' : `Las ${of} fotos`;
    return `${which} no ${one ? 'está' : 'están'} en este navegador: ${some(names)}. ${one ? 'Elígela o suéltala' : 'Elígelas o suéltalas'} aquí: cada una vuelve a su sitio.`;
  },
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)}: ya no ${names.length === 1 ? 'está' : 'están'} en este navegador, pero sus fotogramas sí. Para usar otros, añade el vídeo otra vez.`,
  photosNeverSaved: (names: readonly string[]) =>
    `La aplicación se cerró antes de guardar ${some(names)}. ${names.length === 1 ? 'Elígela' : 'Elígelas'} otra vez.`,
  saveAgain: 'Guardar otra vez',
  goOnWithout: 'Seguir sin eso',
  saveToFile: 'Guardar en un archivo',
  conflict: 'Otra pestaña cambió este proyecto. Esta pestaña sigue con una copia.',

  // Projects
  projects: 'Proyectos',
  projectName: 'Nombre del proyecto',
  untitled: 'Sin título',
  newProject: 'Proyecto nuevo',
  openProject: 'Abrir archivo de proyecto',
  saveProject: 'Guardar archivo de proyecto',
  projectFile: 'Archivo de proyecto',
  openNamed: (name: string) => `Abrir ${name}`,
  duplicateNamed: (name: string) => `Duplicar ${name}`,
  deleteNamed: (name: string) => `Borrar ${name}`,
  renameNamed: (name: string) => `Cambiar el nombre de ${name}`,
  newNameOf: (name: string) => `Nombre nuevo de ${name}`,
  sampleAlbum: 'Álbum de muestra',
  openNow: 'Abierto ahora',
  projectAbout: (photos: number, when: string) =>
    `${photos === 1 ? '1 foto' : `${photos} fotos`}${when && `, ${when}`}`,
  noProjects: 'Tu trabajo se guarda aquí automáticamente.',
  projectDeleted: (name: string) => `${name} se ha borrado.`,
  bringBack: 'Restaurar',
  projectNotOpened: (why: string) => `No se pudo abrir el proyecto: ${why}`,
  projectFileNotOpened: (name: string, why: string) => `No se pudo abrir ${name}: ${why}`,
  projectNotSaved: (why: string) => `No se pudo guardar el proyecto como archivo: ${why}`,
  projectReasons: {
    'damaged-project': 'está dañado o no es un proyecto de Inkpanel. Tu página no ha cambiado.',
    'too-large-project': 'supera los límites de un proyecto. Tu página no ha cambiado.',
    'silent-project': 'la lectura del archivo se interrumpió tras un minuto. Comprueba el disco e inténtalo otra vez.',
    'newer-project': 'se guardó con una versión más nueva de Inkpanel. Recarga esta pestaña para actualizar.',
    'not-saved': 'tu trabajo no está guardado. Guárdalo primero en un archivo (Guardar archivo de proyecto).',
    'missing-project': 'se borró.',
    'no-storage': 'este navegador bloquea aquí el almacenamiento de sitios.',
    'too-large': 'el archivo pasaría de 4 GB.',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `Se han abierto ${others.length + 1} proyectos, cada uno por separado. ${shown} está en la página; ${others.length === 1 ? `${others[0]} está` : `otros ${others.length} están`} en Proyectos.`,
  photosWithProject: (n: number, name: string) =>
    n === 1
      ? `La foto que venía con él se ha añadido a ${name}.`
      : `Las ${n} fotos que venían con él se han añadido a ${name}.`,
  projectBroken: (name: string, why: string) => `No se puede mostrar ${name}: ${why}.`,
  brokenReasons: {
    'damaged-project': 'una parte está dañada',
    'too-large-project': 'supera los límites de un proyecto',
    'newer-project': 'se guardó con una versión más nueva de Inkpanel. Recarga esta pestaña para actualizar',
  } as Record<string, string>,
  brokenOtherwise: 'una parte no se puede dibujar',
  brokenKept: 'El proyecto y sus fotos no han cambiado.',
  partsLeftOut: (name: string, n: number) =>
    `${name} está abierto sin ${n === 1 ? 'una parte que no se pudo leer' : `${n} partes que no se pudieron leer`}.`,
  openAnother: 'Abrir otro',
  saveAsFile: 'Guardar como archivo',
  goBack: 'Restaurar la última versión correcta',
  noGoodState: 'No hay ninguna versión anterior que restaurar.',
  wentBack: (name: string) => `Se ha restaurado la última versión correcta de ${name}.`,
  openingProject: (name: string) => `Abriendo ${name}`,
  openingLast: 'Abriendo tu proyecto',
  openElsewhere: (name: string) => `${name} está abierto en otra pestaña.`,
  opensWhenFree: 'Se abre aquí cuando cierres la otra pestaña.',
  openCopy: 'Abrir una copia',

  // Pages shown
  pagesShown: 'Historial de la página',
  pagesShownAt: (n: number, of: number) => `Historial de la página, ${n}/${of}`,
  pageNumber: (n: number) => `Página ${n}`,
  versionFrom: (n: number) => `de la versión ${n}`,
  favouritePage: 'Página favorita',
  favouritePages: 'Solo favoritas',
  versionNumber: (n: number) => `Versión ${n}`,
  compareShort: 'Comparar',
  comparePage: (n: number) => `Comparar versión ${n}`,
  comparedAll: 'Mostrar todas las versiones',
  compareSecond: 'Elige la segunda versión para comparar',
  noFavouritePages: 'Aún no hay favoritas. Pulsa el corazón de una página que te guste.',
};
