export const startStrings = {
  lead: ['Suelta tus fotos.', 'Saca una página de cómic.'],
  leadMore: 'Inkpanel las elige, las recorta, las entinta y las coloca. Baraja hasta que te encante.',
  chooseFiles: 'Elegir fotos o un vídeo',
  filesLabel: 'Fotos o vídeo',
  trySamples: 'Probar el álbum de muestra',
  startPages: 'Tres páginas de cómic hechas con el álbum de ejemplo',
  recentProjects: 'Proyectos recientes',
  privacy: 'Nada sale de este dispositivo.',
  dropHere: 'Suelta para añadir tus fotos',
  framed: 'Inkpanel no funciona dentro de otros sitios web, para protegerte del clickjacking.',
  openInTab: 'Abrir Inkpanel en una pestaña nueva',
  starting: 'Iniciando Inkpanel',
};
