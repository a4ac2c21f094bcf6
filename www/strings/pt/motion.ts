export const motionStrings = {
  motion: {
    help: 'As páginas do storyboard como filme: cada uma aparece inteira e depois quadro a quadro, e o que é dito surge conforme se lê.',
    seconds: 'Segundos por quadro',
    change: 'De página a página',
    preview: 'Página animada',
    living: 'Quadros de vídeos se movem',
    larger: 'Cada quadro aumenta o arquivo em até dois megabytes.',
    apart: 'Os quadros ficam parados: o estilo desenha as figuras à parte.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} de ${of}, página ${page}, quadro ${panel}` : `${time} de ${of}, página ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 página' : `${pages} páginas`}, ${length} a ${fps} quadros por segundo`,
    planning: 'organizando as páginas…',
    failed: (why: string) => `A página animada não pode ser preparada: ${why}`,
    making: (percent: string) => `Criando a página animada, ${percent}`,
    saved: 'A página animada foi salva.',
  },
};
