/** What the core and the data files call things, by their ids. */

import { blocks, parameters } from './blocks.ts';
import { layouts } from './layouts.ts';
import { styles } from './styles.ts';
import type { Names } from '../names.ts';

export const names: Names = {
  blocks,
  parameters,
  layouts,
  styles,
  families: {
    cinema: 'Cine',
    circle: 'Círculo',
    columns: 'Columnas',
    grid: 'Cuadrícula',
    hero: 'Protagonista',
    inset: 'Insertada',
    landscape: 'Apaisada',
    manga: 'Manga',
    mosaic: 'Mosaico',
    overlap: 'Superpuesta',
    rows: 'Filas',
    slanted: 'Inclinada',
    splash: 'Página entera',
    square: 'Cuadrada',
    strip: 'Tira',
    tall: 'Vertical',
    pop: 'Pop',
    sketch: 'Boceto',
    hatch: 'Trama',
    halftone: 'Semitono',
    ink: 'Tinta',
    blueprint: 'Cianotipo',
    vintage: 'De época',
    comic: 'Cómic',
    duotone: 'Bitono',
    noir: 'Negro',
    watercolour: 'Acuarela',
    woodcut: 'Xilografía',
    paper: 'Papel',
  },
  choices: {
    hatch: 'Trama',
    cross_hatch: 'Trama cruzada',
    dots: 'Puntos',
    lines: 'Líneas',
    woodcut: 'Xilografía',
    stipple: 'Punteado',
    cmyk: 'CMYK',
    mono: 'Una tinta',
  },
  verdicts: {
    same: (name) => `igual que ${name}`,
    sharpest: (of) => `la más nítida de ${of}`,
    only: 'la única así',
    blurred: 'desenfocada',
  },
};
