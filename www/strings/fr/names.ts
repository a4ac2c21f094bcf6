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
    cinema: 'Cinéma',
    circle: 'Cercle',
    columns: 'Colonnes',
    grid: 'Grille',
    hero: 'Grande case',
    inset: 'Incrustation',
    landscape: 'Paysage',
    manga: 'Manga',
    mosaic: 'Mosaïque',
    overlap: 'Superposition',
    rows: 'Rangées',
    slanted: 'Inclinée',
    splash: 'Pleine page',
    square: 'Carrée',
    strip: 'Strip',
    tall: 'Haute',
    pop: 'Pop',
    sketch: 'Croquis',
    hatch: 'Hachures',
    halftone: 'Trame',
    ink: 'Encre',
    blueprint: 'Plan',
    vintage: 'Ancien',
    comic: 'BD',
    duotone: 'Bichromie',
    noir: 'Noir',
    watercolour: 'Aquarelle',
    woodcut: 'Gravure sur bois',
    paper: 'Papier',
  },
  choices: {
    hatch: 'Hachures',
    cross_hatch: 'Hachures croisées',
    dots: 'Points',
    lines: 'Lignes',
    woodcut: 'Gravure sur bois',
    stipple: 'Pointillé',
    cmyk: 'CMJN',
    mono: 'Une encre',
  },
  verdicts: {
    same: (name) => `identique à ${name}`,
    sharpest: (of) => `la plus nette de ${of}`,
    only: 'la seule de ce genre',
    blurred: 'floue',
  },
};
