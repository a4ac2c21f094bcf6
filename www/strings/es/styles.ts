/** Names of the designed styles. */
export const STYLES: Record<string, string> = {
  acid: 'Ácido', ballpoint: 'Bolígrafo', banknote: 'Billete', 'ben-day': 'Ben Day', billboard: 'Valla', 'bister-brush': 'Pincel bistre', blueprint: 'Plano azul',
  broadcast: 'Emisión', brush: 'Pincel y tinta', campaign: 'Cartel de campaña', chalkboard: 'Pizarra', charcoal: 'Carboncillo', 'colour-hatch': 'Trama en color',
  'coloured-pencil': 'Lápiz de color', 'comic-bold': 'Viñeta a toda página', 'comic-soft': 'Tira dominical', comic: 'Cómic', 'cross-hatch': 'Trama cruzada',
  'cross-process': 'Proceso cruzado', cyanotype: 'Cianotipia', daguerreotype: 'Daguerrotipo', 'duotone-ember': 'Ascua', 'duotone-forest': 'Bosque',
  'duotone-midnight': 'Medianoche', 'duotone-orchid': 'Orquídea', 'duotone-sunset': 'Ocaso', engraving: 'Grabado', etching: 'Aguafuerte',
  'faded-print': 'Copia desvaída', gouache: 'Gouache', 'graphic-novel': 'Novela gráfica', 'hatched-sepia': 'Trama sepia', 'ink-fine': 'Rotulador fino',
  'ink-wash': 'Aguada de tinta', ink: 'Tinta', 'iron-gall': 'Tinta ferrogálica', 'lacquer-poster': 'Cartel lacado', 'ligne-claire': 'Color claro',
  'line-and-wash': 'Línea y aguada', linocut: 'Linograbado', 'manga-clear': 'Línea clara', 'manga-rose': 'Manga rosa', manga: 'Manga', moonlight: 'Luz de luna',
  neon: 'Neón', newsprint: 'Papel prensa', 'night-comic': 'Cómic nocturno', 'noir-hard': 'Novela dura', noir: 'Negro', oil: 'Óleo', 'paper-a': 'Color grabado',
  'paper-b': 'Pincel sepia', 'paper-c': 'Cartel entintado', 'paper-d': 'Dibujo tramado', pastel: 'Pastel', pencil: 'Lápiz', phosphor: 'Fósforo', photostat: 'Fotocopia',
  pointillist: 'Puntillista', pop: 'Arte pop', pulp: 'Portada pulp', 'riso-duo': 'Riso rosa y azul', 'riso-red': 'Riso rojo', 'riso-teal': 'Riso turquesa',
  sanguine: 'Sanguina', scratchboard: 'Esgrafiado', screenprint: 'Serigrafía', 'sepia-sketch': 'Boceto sepia', silverpoint: 'Papel teñido', stipple: 'Punteado',
  streetlight: 'Farola', 'tinted-etching': 'Aguafuerte teñido', 'ukiyo-e': 'Mundo flotante', vintage: 'De época', watercolour: 'Acuarela',
  'woodcut-colour': 'Xilografía en color', woodcut: 'Xilografía',
};
