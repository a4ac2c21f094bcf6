/**
 * The shapes of the JSON that crosses to the core. The core defines and validates them; here they are types only.
 */

import type { PhotoMeta } from './protocol.ts';

export type Block = { id: string; label: string; help: string; input: string; output: string; params: BlockParam[] };
/** A number, an entry of its choices, or whether it is on. */
export type ParamValue = number | string | boolean;
export type BlockParam = {
  id: string;
  label: string;
  help: string;
  kind: string;
  default: ParamValue;
  min?: number;
  max?: number;
  step?: number;
  unit?: string;
  choices?: string[];
};

/** points; the first is joined to the last */
type Polygon = [number, number][];
type Circle = { x: number; y: number; radius: number };
type Shape = { polygon?: Polygon; circle?: Circle };

/** A page template in unit coordinates. */
export type Layout = { id: string; name: string; family: string; aspect: number; count: number; panels: LayoutPanel[] };
type LayoutPanel = { shape: Shape; weight: number; overlay: boolean };

/** A layout file in full. */
export type Template = {
  id: string;
  name: string;
  family: string;
  aspect: number;
  tree?: object;
  polygons?: object;
  weights?: number[];
};

/**
 * A layout in the list: `own` is its place among a person's own, else null; `base` and `over` are SVG paths of its
 * panels and its overlays on a page 100 wide.
 */
export type LayoutEntry = {
  id: string;
  name: string;
  family: string;
  count: number;
  own: number | null;
  base: string;
  over: string;
};

/**
 * What can be done to a layout on a page: `base` panels lie below overlays, `adjacent` are those with a common edge,
 * `editable` says whether it is made of cuts.
 */
export type LayoutFacts = {
  id: string;
  name: string;
  family: string;
  count: number;
  base: number;
  good: boolean;
  editable: boolean;
  adjacent: [number, number][];
  cuts: Cut[];
};

/** A cut between panels, in page widths; moved by `d` of them its `fraction` changes by `d / length`. */
export type Cut = {
  axis: 'rows' | 'columns';
  from: [number, number];
  to: [number, number];
  fraction: number;
  slant: number;
  length: number;
};

export type LayoutChange =
  | { type: 'move-cut'; cut: number; fraction: number; slant: number }
  | { type: 'split'; panel: number; axis: 'rows' | 'columns' }
  | { type: 'remove'; panel: number };

export type Style = {
  id: string;
  name: string;
  tags: string[];
  background?: object[];
  foreground?: object[];
  ink?: string;
};

/** Lengths are fractions of the page's width; `width` and `height` are the pixels of the export. */
export type PageSettings = {
  width: number;
  height: number;
  dpi: number;
  gutter: number;
  margin: number;
  border: number;
  cornerRadius: number;
  paper: string;
  borderColor: string;
};

/** Where the panels are on a page whose width is 1, gutters and margins applied. */
export type Geometry = { width: number; height: number; panels: (Shape & { bounds: Bounds; overlay: boolean })[] };
export type Bounds = { x: number; y: number; width: number; height: number };

/** `edited`: the crop was made by hand, and stays while the photo stays in the panel. */
export type PanelUse = { photo: string | null; crop: Bounds | null; locked?: boolean; edited?: boolean };

/**
 * A caption, a balloon or a sound effect; what is left out is usual. Places are fractions of the bounds of its panel, or
 * of the page where it has none; `width` and `size` (of an em) are in page widths, null fits the text; `auto`: nobody
 * has moved it, so it goes where it hides no face.
 */
export type Word = {
  kind: 'caption' | 'balloon' | 'effect';
  text: string;
  shape?: 'oval' | 'thought' | 'shout' | 'whisper';
  panel?: number | null;
  x?: number;
  y?: number;
  width?: number | null;
  size?: number | 'auto' | null;
  tail?: { x: number; y: number } | null;
  font?: string;
  color?: string;
  fill?: string;
  angle?: number;
  arc?: number;
  auto?: boolean;
};

/** Where a word is on the page without its tail, in page widths; `cut`: the end of its text found no room. */
export type WordBox = Bounds & { tip: [number, number] | null; size: number; cut: boolean };

/** A page, as plain data: which photo goes where, in which layout and style. */
export type PageDocument = {
  version: number;
  seed: number;
  layout: string | { id: string };
  style: string | { id?: string };
  order: string[];
  panels: PanelUse[];
  merges: number[][];
  page: PageSettings;
  words?: Word[];
};

export type Keep = { layout: boolean; style: boolean; photos: boolean };

export type PlanRequest = {
  seed: number;
  photos: PhotoMeta[];
  page: PageSettings;
  current: PageDocument | null;
  keep: Keep;
  layout?: string | object;
  style?: string | object;
  panels?: number;
  mode?: 'shuffle' | 'photos';
  merge?: boolean;
  merges?: number[][];
  /** Logarithms of how much more often families of layouts and styles are drawn, by id, to 1.6 either way. */
  taste?: { families: Record<string, number>; styles: Record<string, number> };
  /** Layouts and styles that were shown just now, by id: they are not drawn. */
  avoid?: { layouts: string[]; styles: string[] };
  styling?: { extra: object[]; invented: number; keepLines: boolean; keepColours: boolean };
};

export type Verdict = { id: string; group: number; kept: boolean; why: string };

/** What is wrong with a file of subtitles; lines are counted from 1. */
export type SubtitleFlaw =
  | { kind: 'large' | 'binary' | 'header' | 'empty' }
  | { kind: 'order'; line: number }
  | { kind: 'stray' | 'time'; line: number; text: string };
/** Words for frames at whose times something is said, and how many subtitles were read, left out, and cut. */
export type ReadSubtitles = { words: Word[]; cues: number; left: number; cut: number } | { flaw: SubtitleFlaw };

export {};
