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

/**
 * A layout file in full.
 * @typedef {{ id: string, name: string, family: string, aspect: number, tree?: object, polygons?: object, weights?: number[] }} Template
 */

/**
 * A layout in the list: `own` is its place among a person's own, else null; `base` and `over` are SVG paths of its
 * panels and its overlays on a page 100 wide.
 * @typedef {{ id: string, name: string, family: string, count: number, own: number | null, base: string, over: string }} LayoutEntry
 */

/**
 * What can be done to a layout on a page: `base` panels lie below overlays, `adjacent` are those with a common edge,
 * `editable` says whether it is made of cuts.
 * @typedef {{
 *   id: string, name: string, family: string, count: number, base: number, good: boolean, editable: boolean,
 *   adjacent: [number, number][], cuts: Cut[],
 * }} LayoutFacts
 */

/**
 * A cut between panels, in page widths; moved by `d` of them its `fraction` changes by `d / length`.
 * @typedef {{
 *   axis: 'rows' | 'columns', from: [number, number], to: [number, number], fraction: number, slant: number, length: number,
 * }} Cut
 */

/**
 * @typedef {(
 *   | { type: 'move-cut', cut: number, fraction: number, slant: number }
 *   | { type: 'split', panel: number, axis: 'rows' | 'columns' }
 *   | { type: 'remove', panel: number }
 * )} LayoutChange
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

/**
 * `edited`: the crop was made by hand, and stays while the photo stays in the panel.
 * @typedef {{ photo: string | null, crop: Bounds | null, locked?: boolean, edited?: boolean }} PanelUse
 */

/**
 * A caption, a balloon or a sound effect; what is left out is usual. Places are fractions of the bounds of its panel, or
 * of the page where it has none; `width` and `size` (of an em) are in page widths, null fits the text; `auto`: nobody
 * has moved it, so it goes where it hides no face.
 * @typedef {{
 *   kind: 'caption' | 'balloon' | 'effect', text: string, shape?: 'oval' | 'thought' | 'shout' | 'whisper', panel?: number | null,
 *   x?: number, y?: number, width?: number | null, size?: number | 'auto' | null, tail?: { x: number, y: number } | null,
 *   font?: string, color?: string, fill?: string, angle?: number, arc?: number, auto?: boolean,
 * }} Word
 */

/**
 * Where a word is on the page without its tail, in page widths; `cut`: the end of its text found no room.
 * @typedef {Bounds & { tip: [number, number] | null, size: number, cut: boolean }} WordBox
 */

/**
 * A page, as plain data: which photo goes where, in which layout and style.
 * @typedef {{
 *   version: number, seed: number, layout: string | { id: string }, style: string | { id?: string }, order: string[],
 *   panels: PanelUse[], merges: number[][], page: PageSettings, words?: Word[],
 * }} PageDocument
 */

/** @typedef {{ layout: boolean, style: boolean, photos: boolean }} Keep */

/**
 * @typedef {{
 *   seed: number, photos: import('./protocol.js').PhotoMeta[], page: PageSettings, current: PageDocument | null,
 *   keep: Keep, layout?: string | object, style?: string | object, panels?: number, mode?: 'shuffle' | 'photos',
 *   merge?: boolean, merges?: number[][], styling?: { extra: object[], invented: number, keepLines: boolean, keepColours: boolean },
 * }} PlanRequest
 */

/** @typedef {{ id: string, group: number, kept: boolean, why: string }} Verdict */

export {};
