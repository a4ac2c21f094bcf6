export const motionStrings = {
  motion: {
    help: 'Reproduce las páginas como cómic animado: primero la página entera y luego viñeta a viñeta. El diálogo aparece al leerlo.',
    seconds: 'Segundos por viñeta',
    change: 'Transición de página',
    preview: 'Cómic animado',
    living: 'Animar viñetas con fotogramas de vídeo',
    larger: 'Cada viñeta animada añade hasta dos megabytes al archivo.',
    apart: 'Las viñetas no se animan, porque el estilo dibuja los motivos por separado.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} de ${of}, página ${page}, viñeta ${panel}` : `${time} de ${of}, página ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 página' : `${pages} páginas`}, ${length} a ${fps} fotogramas por segundo`,
    planning: 'planificando las páginas…',
    failed: (why: string) => `No se pudo crear el cómic animado: ${why}`,
    making: (percent: string) => `Creando el cómic animado, ${percent}`,
    saved: 'Se guardó el cómic animado.',
  },
};
