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
    cinema: 'Cinema',
    circle: 'Círculo',
    columns: 'Colunas',
    grid: 'Grade',
    hero: 'Destaque',
    inset: 'Encaixe',
    landscape: 'Paisagem',
    manga: 'Mangá',
    mosaic: 'Mosaico',
    overlap: 'Sobreposto',
    rows: 'Linhas',
    slanted: 'Inclinado',
    splash: 'Página inteira',
    square: 'Quadrado',
    strip: 'Tira',
    tall: 'Alto',
    pop: 'Pop',
    sketch: 'Esboço',
    hatch: 'Hachura',
    halftone: 'Retícula',
    ink: 'Nanquim',
    blueprint: 'Planta azul',
    vintage: 'Antigo',
    comic: 'Quadrinhos',
    duotone: 'Duotone',
    noir: 'Noir',
    watercolour: 'Aquarela',
    woodcut: 'Xilogravura',
    paper: 'Papel',
  },
  choices: {
    hatch: 'Hachura',
    cross_hatch: 'Hachura cruzada',
    dots: 'Pontos',
    lines: 'Linhas',
    woodcut: 'Xilogravura',
    stipple: 'Pontilhado',
    cmyk: 'CMYK',
    mono: 'Uma tinta',
  },
  verdicts: {
    same: (name) => `igual a ${name}`,
    sharpest: (of) => `a mais nítida de ${of}`,
    only: 'a única assim',
    blurred: 'desfocada',
  },
};
