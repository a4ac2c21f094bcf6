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
    cinema: 'Kino',
    circle: 'Kreis',
    columns: 'Spalten',
    grid: 'Raster',
    hero: 'Aufmacher',
    inset: 'Einsatz',
    landscape: 'Querformat',
    manga: 'Manga',
    mosaic: 'Mosaik',
    overlap: 'Überlappend',
    rows: 'Zeilen',
    slanted: 'Schräg',
    splash: 'Ganzseitig',
    square: 'Quadrat',
    strip: 'Strip',
    tall: 'Hoch',
    pop: 'Pop',
    sketch: 'Skizze',
    hatch: 'Schraffur',
    halftone: 'Druckraster',
    ink: 'Tusche',
    blueprint: 'Blaupause',
    vintage: 'Alt',
    comic: 'Comic',
    duotone: 'Duplex',
    noir: 'Noir',
    watercolour: 'Aquarell',
    woodcut: 'Holzschnitt',
    paper: 'Papier',
  },
  choices: {
    hatch: 'Schraffur',
    cross_hatch: 'Kreuzschraffur',
    dots: 'Punkte',
    lines: 'Linien',
    woodcut: 'Holzschnitt',
    stipple: 'Punktierung',
    cmyk: 'CMYK',
    mono: 'Eine Farbe',
  },
  verdicts: {
    same: (name) => `gleich wie ${name}`,
    sharpest: (of) => `das schärfste von ${of}`,
    only: 'das einzige seiner Art',
    blurred: 'unscharf',
  },
};
