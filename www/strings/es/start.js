// @ts-check
export const startStrings = {
  lead: ['Suelta tus fotos.', 'Saca una página de cómic.'],
  leadMore: 'Inkpanel las elige, las recorta, las entinta y las coloca. Baraja hasta que te encante.',
  chooseFiles: 'Elegir fotos o un vídeo',
  filesLabel: 'Fotos o vídeo',
  trySamples: 'Probar el álbum de muestra',
  privacy: 'Nada sale de este dispositivo.',
  dropHere: 'Suelta para añadir tus fotos',
  starting: 'Preparando la tinta',
};
