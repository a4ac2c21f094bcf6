export const motionStrings = {
  motion: {
    help: 'Las páginas del storyboard como película: cada una se ve entera y luego viñeta a viñeta, y lo que se dice aparece al leerlo.',
    seconds: 'Segundos por viñeta',
    change: 'De página a página',
    preview: 'Página animada',
    living: 'Las viñetas de vídeos se mueven',
    larger: 'Cada viñeta añade hasta dos megabytes al archivo.',
    apart: 'Las viñetas no se mueven: el estilo dibuja las figuras aparte.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} de ${of}, página ${page}, viñeta ${panel}` : `${time} de ${of}, página ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 página' : `${pages} páginas`}, ${length} a ${fps} fotogramas por segundo`,
    planning: 'ordenando las páginas…',
    failed: (why: string) => `No se puede preparar la página animada: ${why}`,
    making: (percent: string) => `Creando la página animada, ${percent}`,
    saved: 'Se guardó la página animada.',
  },
};
