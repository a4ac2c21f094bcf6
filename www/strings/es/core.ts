/** What the core and the data files call things, by their ids. A name that is not here stays as it is. */

import { BLOCKS, PARAMETERS } from './blocks.ts';
import { LAYOUTS } from './layouts.ts';
import { STYLES } from './styles.ts';
import type { Block, Parameter } from '../en/core.ts';

/** Families of layouts and tags of styles. */
const FAMILIES: Record<string, string> = {
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
};

const CHOICES: Record<string, string> = {
  hatch: 'Trama',
  cross_hatch: 'Trama cruzada',
  dots: 'Puntos',
  lines: 'Líneas',
  woodcut: 'Xilografía',
  stipple: 'Punteado',
  cmyk: 'CMYK',
  mono: 'Una tinta',
};

const asName = (id: string) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

export const coreStrings = {
  familyName: (id: string) => FAMILIES[id] ?? asName(id),
  blockName: (block: Block) => BLOCKS[block.id]?.[0] ?? block.label,
  blockHelp: (block: Block) => BLOCKS[block.id]?.[1] ?? block.help,
  parameterName: (block: string, parameter: Parameter) =>
    PARAMETERS[`${block}.${parameter.id}`]?.[0] ?? parameter.label,
  parameterHelp: (block: string, parameter: Parameter) =>
    PARAMETERS[`${block}.${parameter.id}`]?.[1] ?? parameter.help ?? '',
  choiceName: (id: string) => CHOICES[id] ?? asName(id),
  /** The core's four sentences. */
  verdict: (why: string) =>
    why
      .replace(/^same as (.*)$/s, 'igual que $1')
      .replace(/^sharpest of (\d+)$/, 'la más nítida de $1')
      .replace(/^only one like it$/, 'la única así')
      .replace(/^blurred$/, 'desenfocada'),
  layoutTitle: (layout: { id: string; name: string }) => LAYOUTS[layout.id] ?? layout.name,
  styleTitle: (style: { id: string; name: string }) => STYLES[style.id] ?? style.name,
};
