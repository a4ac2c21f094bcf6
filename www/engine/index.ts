/** What other sites import: the npm package `inkpanel`, made by `cargo xtask package`. */

export type { Found } from './detector.ts';
export type { Block, BlockParam, Layout, PageDocument, PageSettings, PlanRequest, Style, Word } from './documents.ts';
export type { Call, Engine } from './engine.ts';
export type { PhotoMeta, PixelPatch } from './protocol.ts';

export { createEngine } from './engine.ts';
