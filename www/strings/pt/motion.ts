export const motionStrings = {
  motion: {
    help: 'Reproduz as páginas como quadrinho animado: primeiro a página inteira, depois quadro a quadro. O diálogo aparece conforme se lê.',
    seconds: 'Segundos por quadro',
    change: 'Transição de página',
    preview: 'Quadrinho animado',
    living: 'Animar quadros com imagens do vídeo',
    larger: 'Cada quadro animado aumenta o arquivo em até dois megabytes.',
    apart: 'Os quadros não são animados, porque o estilo desenha os assuntos à parte.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} de ${of}, página ${page}, quadro ${panel}` : `${time} de ${of}, página ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 página' : `${pages} páginas`}, ${length} a ${fps} quadros por segundo`,
    planning: 'planejando as páginas…',
    failed: (why: string) => `Não foi possível criar o quadrinho animado: ${why}`,
    making: (percent: string) => `Criando o quadrinho animado, ${percent}`,
    saved: 'O quadrinho animado foi salvo.',
  },
};
