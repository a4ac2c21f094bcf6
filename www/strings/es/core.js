// @ts-check
/** What the core and the data files call things, by their ids. A name that is not here stays as it is. */

import { BLOCKS, PARAMETERS } from './blocks.js';
import { LAYOUTS } from './layouts.js';
import { STYLES } from './styles.js';

/** @typedef {import('../en/core.js').Block} Block @typedef {import('../en/core.js').Parameter} Parameter */

/** Families of layouts and tags of styles. @type {Record<string, string>} */
const FAMILIES = {
  cinema: 'Cine', circle: 'Círculo', columns: 'Columnas', grid: 'Cuadrícula', hero: 'Protagonista', inset: 'Insertada', landscape: 'Apaisada', manga: 'Manga',
  mosaic: 'Mosaico', overlap: 'Superpuesta', rows: 'Filas', slanted: 'Inclinada', splash: 'Página entera', square: 'Cuadrada', strip: 'Tira', tall: 'Vertical',
  pop: 'Pop', sketch: 'Boceto', hatch: 'Trama', halftone: 'Semitono', ink: 'Tinta', blueprint: 'Cianotipo', vintage: 'De época', comic: 'Cómic',
  duotone: 'Bitono', noir: 'Negro', watercolour: 'Acuarela', woodcut: 'Xilografía', paper: 'Papel',
};

/** @type {Record<string, string>} */
const CHOICES = {
  hatch: 'Trama', cross_hatch: 'Trama cruzada', dots: 'Puntos', lines: 'Líneas', woodcut: 'Xilografía', stipple: 'Punteado', cmyk: 'CMYK', mono: 'Una tinta',
};

/** @param {string} id */
const asName = (id) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

export const coreStrings = {
  /** @param {string} id */
  familyName: (id) => FAMILIES[id] ?? asName(id),
  blockName: (/** @type {Block} */ block) => BLOCKS[block.id]?.[0] ?? block.label,
  blockHelp: (/** @type {Block} */ block) => BLOCKS[block.id]?.[1] ?? block.help,
  /** @param {string} block @param {Parameter} parameter */
  parameterName: (block, parameter) => PARAMETERS[`${block}.${parameter.id}`]?.[0] ?? parameter.label,
  /** @param {string} block @param {Parameter} parameter */
  parameterHelp: (block, parameter) => PARAMETERS[`${block}.${parameter.id}`]?.[1] ?? parameter.help ?? '',
  /** @param {string} id */
  choiceName: (id) => CHOICES[id] ?? asName(id),
  /** The core's four sentences. @param {string} why */
  verdict: (why) => why
    .replace(/^same as (.*)$/s, 'igual que $1')
    .replace(/^sharpest of (\d+)$/, 'la más nítida de $1')
    .replace(/^only one like it$/, 'la única así')
    .replace(/^blurred$/, 'desenfocada'),
  layoutTitle: (/** @type {{ id: string, name: string }} */ layout) => LAYOUTS[layout.id] ?? layout.name,
  styleTitle: (/** @type {{ id: string, name: string }} */ style) => STYLES[style.id] ?? style.name,
};
