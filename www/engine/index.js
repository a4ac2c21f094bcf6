// @ts-check
/** What other sites import: the npm package `inkpanel`, made by `cargo xtask package`. */

export { createEngine } from './engine.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').Call} Call */
/** @typedef {import('./documents.js').Block} Block */
/** @typedef {import('./documents.js').BlockParam} BlockParam */
/** @typedef {import('./documents.js').Layout} Layout */
/** @typedef {import('./documents.js').Style} Style */
/** @typedef {import('./documents.js').PageDocument} PageDocument */
/** @typedef {import('./documents.js').PageSettings} PageSettings */
/** @typedef {import('./documents.js').PlanRequest} PlanRequest */
/** @typedef {import('./documents.js').Word} Word */
/** @typedef {import('./detector.js').Found} Found */
/** @typedef {import('./protocol.js').PixelPatch} PixelPatch */
/** @typedef {import('./protocol.js').PhotoMeta} PhotoMeta */
