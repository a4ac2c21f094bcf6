// @ts-check
/**
 * The shapes of the JSON that crosses to the core. The core defines and validates them; here they are types only.
 */

/**
 * @typedef {{ id: string, label: string, help: string, input: string, output: string, params: BlockParam[] }} Block
 * @typedef {{ id: string, label: string, help: string, kind: string, default: any, min?: number, max?: number, step?: number, unit?: string, choices?: string[] }} BlockParam
 */

/** @typedef {[number, number][]} Polygon points; the first is joined to the last */
/** @typedef {{ x: number, y: number, radius: number }} Circle */
/** @typedef {{ polygon?: Polygon, circle?: Circle }} Shape */

/**
 * A page template in unit coordinates.
 * @typedef {{ id: string, name: string, family: string, aspect: number, count: number, panels: LayoutPanel[] }} Layout
 * @typedef {{ shape: Shape, weight: number, overlay: boolean }} LayoutPanel
 */

/** @typedef {{ id: string, name: string, tags: string[], background?: object[], foreground?: object[], ink?: string }} Style */

/**
 * Lengths are fractions of the page's width; `width` and `height` are the pixels of the export.
 * @typedef {{
 *   width: number, height: number, dpi: number, gutter: number, margin: number, border: number,
 *   cornerRadius: number, paper: string, borderColor: string,
 * }} PageSettings
 */

/**
 * Where the panels are on a page whose width is 1, gutters and margins applied.
 * @typedef {{ width: number, height: number, panels: (Shape & { bounds: Bounds, overlay: boolean })[] }} Geometry
 * @typedef {{ x: number, y: number, width: number, height: number }} Bounds
 */

/** @typedef {{ photo: string | null, crop: Bounds | null, locked?: boolean }} PanelUse */

/**
 * A page, as plain data: which photo goes where, in which layout and style.
 * @typedef {{
 *   version: number, seed: number, layout: string | { id?: string }, style: string | { id?: string }, order: string[],
 *   panels: PanelUse[], merges: number[][], page: PageSettings, captions: object[],
 * }} PageDocument
 */

/** @typedef {{ layout: boolean, style: boolean, photos: boolean }} Keep */

/**
 * @typedef {{
 *   seed: number, photos: import('./protocol.js').PhotoMeta[], page: PageSettings, current: PageDocument | null,
 *   keep: Keep, layout?: string, style?: string | object, panels?: number, mode?: 'shuffle' | 'photos',
 * }} PlanRequest
 */

/** @typedef {{ id: string, group: number, kept: boolean, why: string }} Verdict */

export {};
