/** What crosses to the core and back. Written out of the types of the core by `cargo xtask bless types`, not by hand. */

/** A state of a project. */
export type Project = {
  /** What the person calls it, empty until then. */
  name: string,
  /** The photos, in the order in which they were added. */
  tray: ReadonlyArray<TrayItem>,
  /** Photos whose fingerprints differ in at most so many of 64 bits show the same picture. */
  alike: number,
  /** How the photos are ordered. */
  order: Order,
  /** Parts of the page that no shuffle changes. */
  locks: Locks,
  /** The wanted number of panels, none for any. */
  panels: number | null,
  /** Size, gutters and colours. */
  settings: PageSettings,
  /** The page that is edited; none while there is none. */
  page: PageDocument | null,
  /** Names the page among those shown. */
  pageId: number,
  /** Names its place in the storyboard through all its versions. */
  sheet: number,
  /** The other pages of the storyboard, in order. */
  others: ReadonlyArray<Sheet>,
  /** How many of these come before the page. */
  at: number,
  /** The style in the designer. */
  draft: Draft | null,
  /** Words of photos that no page shows: they come back with these. */
  waiting?: ReadonlyArray<Word>,
  /** A person's own styles, which all projects share. */
  mine: ReadonlyArray<Style>,
  /** Styles that are favourites, which all projects share. */
  favourites: ReadonlyArray<Style>,
  /** A person's own layouts, which all projects share. */
  ownLayouts: ReadonlyArray<Template>,
  /** The favourites among the pages shown, by their ids. */
  loved: ReadonlyArray<number>,
  /** How a shuffle draws styles. */
  styling: Styling,
  /** How the shots are counted, ordered and laid out; not told where it is as in an empty project. */
  board?: Board | null,
};

/** A photo in the tray. */
export type TrayItem = {
  /** Its id. */
  id: string,
  /** What the person chose; none follows the selection's verdict. */
  use: boolean | null,
  /** The point of it that matters, where a person marked one. */
  focus?: Focus | null,
  /** A person wants to see it large. */
  starred?: boolean,
  /** Which part of it is its subject, as a person corrected it; none leaves that to what was found. */
  mask?: string,
  /** What is told of it as a shot. */
  shot?: Shot,
};

/** What is told of a photo as a shot. What is empty was not told. */
export type Shot = {
  /** The scene that it belongs to. */
  scene?: string,
  /** A number of its own, such as 4A; without one it is counted. */
  number?: string,
  /** What happens. */
  action?: string,
  /** What is said. */
  dialogue?: string,
  /** What else is to be known. */
  notes?: string,
  /** How long it is, in frames of the board's rate. */
  frames?: number,
  /** What stands in columns of one's own, by their names. */
  more?: { [key in string]: string },
};

/** How the shots of a project are counted, ordered and laid out. */
export type Board = {
  /** Frames of a counted second, one of `RATES`. */
  fps: number,
  /** How fast such a second passes; the clock's where nothing is told. */
  pace?: Pace,
  /** Columns of one's own, each name once. */
  columns: ReadonlyArray<string>,
  /** Frames on a sheet, one of `FRAMES`. */
  frames: number,
  /** The name of the frames' aspect, one of `ASPECTS`. */
  aspect: string,
  /** The fields stand beside the frames, else under them. */
  beside: boolean,
  /** Ruled lines in the place of the fields, to be written on by hand. */
  ruled: boolean,
  /** Who made it, for the head of the sheets. */
  author: string,
  /** When, as it stands there. */
  date: string,
  /** A picture that stands there, too: a PNG file as a data URL; empty where there is none. */
  logo?: string,
  /** Photos in the order in which a person put them; the others follow where they belong by themselves. */
  order: ReadonlyArray<string>,
};

/** Shots in their order. In JSON what is empty may be missing. */
export type ShotList = {
  /** What the album is called. */
  title: string,
  /** Frames of a counted second, from 1 to 60; 24 where nothing is told. */
  fps: number,
  /** How fast such a second passes; as the clock's where nothing is told. */
  pace?: Pace,
  /** Columns of one's own. */
  columns: ReadonlyArray<string>,
  /** What the columns of a table are called, in the order of `HEADINGS`; English where there are not as many. */
  headings: ReadonlyArray<string>,
  /** The shots. */
  shots: ReadonlyArray<ListedShot>,
};

/** One of them. */
export type ListedShot = {
  /** Its number, counted or its own. */
  number: string,
  /** The scene that it belongs to. */
  scene: string,
  /** What happens. */
  action: string,
  /** What is said. */
  dialogue: string,
  /** What else is to be known. */
  notes: string,
  /** How long it is, in frames; what says nothing is two seconds long. */
  frames?: number,
  /** What stands in columns of one's own. */
  more: { [key in string]: string },
  /** The name of its picture. */
  name: string,
  /** The film that it is a frame of. */
  film?: Film,
};

/** A place in a film. */
export type Film = {
  /** Identifies the video, because others may have the same name. Without keys, videos with one name are one video. */
  key: string,
  /** The name of its file. */
  name: string,
  /** Seconds from its first picture. */
  time: number,
  /** How long it is, in seconds, where that is known. */
  length?: number,
  /** The timecode of its first picture. */
  timecode?: StartTimecode,
};

/** How fast a counted second passes. */
export type Pace = "clock" | "ntsc" | "drop";

/** The timecode of the first frame of a video, as its camera recorded it. */
export type StartTimecode = {
  /** Frames since midnight. */
  frame: number,
  /** Frames per counted second: 30 at 29.97 frames per second. */
  fps: number,
  /** Whether it is drop-frame timecode. */
  drop: boolean,
};

/** What is asked for. In JSON the fields of a `ShotList` beside these. */
export type BoardRequest = {
  /** The shots, and what they are called together. */
  list: ShotList,
  /** Of each shot its picture. */
  pictures: ReadonlyArray<BoardPicture>,
  /** Frames on a sheet, 1 to 12; six where nothing is told. */
  frames: number,
  /** Width over height of the frames, 0.2 to 5; 16:9 where nothing is told. */
  aspect: number,
  /** The text stands beside the frames, else under them. */
  beside: boolean,
  /** Lines to write on in the place of what is told. */
  ruled: boolean,
  /** Who made it. */
  author: string,
  /** When. */
  date: string,
  /** A picture in the head of every sheet. */
  logo?: BoardLogo,
  /** Paper as in North America, else A4. */
  letter: boolean,
  /** The style of the frames: an id, or a style in full. */
  style?: StyleChoice,
  /** What is written before what is told, in the language of the reader. */
  labels: BoardLabels,
};

/** The picture of a shot. */
export type BoardPicture = {
  /** Id of the photo. */
  photo: string,
  /** The part of it that the frame shows. */
  crop: Crop,
  /** Faces of it, which the style takes care of. */
  faces: ReadonlyArray<Crop>,
};

/** The picture in the heads. */
export type BoardLogo = {
  /** The id under which it is known to who draws the sheets. */
  photo: string,
  /** Its width over its height; it is shown with 1/30 to 30. */
  aspect: number,
};

/** What is asked for. */
export type AnimaticRequest = {
  /** The shots, and how many frames a second they are counted in. */
  list: ShotList,
  /** Of each shot its picture. */
  pictures: ReadonlyArray<AnimaticPicture>,
  /** Width and height of the frames in pixels, 64 to 3840, made even as encoders want them. */
  size: [number, number],
  /** Frames a second, 1 to 60; those of the list where nothing is told. */
  fps: number,
  /** How long a shot is that says nothing, in seconds; two where nothing is told. */
  seconds: number,
  /** How long two shots are seen together where one goes over into the other, in seconds; 0 cuts. */
  dissolve: number,
  /** Whether the camera moves. */
  moves: boolean,
  /** Whether what is said, else what happens, stands below. */
  captions: boolean,
  /** Pictures a second of panels that come from a film, where they move; 0 where they do not. */
  living: number,
  /** The style of the pictures: an id, or a style in full. */
  style?: StyleChoice,
};

/** The picture of a shot. */
export type AnimaticPicture = {
  /** Id of the photo. */
  photo: string,
  /** The part of it that a frame shows, of the aspect of the frames. */
  crop: Crop,
  /** Faces of it, which the style takes care of. */
  faces: ReadonlyArray<Crop>,
  /** What was found in it: the camera keeps faces in view, else people and animals, else things. */
  subjects: ReadonlyArray<Subject>,
};

/** Shots in their times. */
export type Animatic = {
  /** Frames of a counted second. */
  fps: number,
  /** Frames of a second of the clock: fewer where the list's seconds pass slower (23.976 of 24). */
  rate: number,
  /** Width and height of the frames in pixels. */
  size: [number, number],
  /** How many frames there are. */
  frames: number,
  /** Pictures a second of panels that move, 0 where none does. */
  living: number,
  /** The shots, or the pages, without gaps between them. */
  clips: ReadonlyArray<AnimaticClip>,
};

/** A shot in its time, or a page that is read. */
export type AnimaticClip = {
  /** Id of its photo; empty for a page. */
  photo: string,
  /** The number of the shot, or of the page. */
  number: string,
  /** Its first frame. */
  start: number,
  /** How long it is, in frames. */
  frames: number,
  /** Its first frame with that of a dissolve, in which the shot before still shows. */
  from: number,
  /** The frame behind its last, a dissolve into the next one counted. */
  to: number,
  /** What the camera sees at `from`, in fractions of the picture. The same as `last` where it stands still. */
  first: Crop,
  /** What it sees at its end. */
  last: Crop,
  /** The picture as a page of one panel, as large as the narrowest view wants it. */
  picture: PageDocument,
  /**
   * An empty page of the size of the frames with the one word that stands below, if there is one. It goes to the middle, its
   * lower edge `Animatic::FOOT` above that of the frame.
   */
  caption: PageDocument | null,
  /** How a page is read, panel by panel; none for a shot. */
  reading: Reading | null,
};

/** What is asked for. */
export type MotionRequest = {
  /** The pages in their order. */
  pages: ReadonlyArray<PageDocument>,
  /** Width and height of the frames in pixels, 64 to 3840, made even as encoders want them. */
  size: [number, number],
  /** Frames a second, 1 to 60. */
  fps: number,
  /** How long a panel is seen at least, in seconds; two where it is 0. */
  seconds: number,
  /** How long two pages are seen together where one goes over into the other, in seconds; 0 cuts. */
  dissolve: number,
  /** Whether the camera moves; else it is at once where it goes. */
  moves: boolean,
  /** Pictures a second of panels that come from a film, where they move; 0 where they do not. */
  living: number,
};

/** How a page is read. */
export type Reading = {
  /** The outline of each panel: corners, in fractions of the page's width and height. */
  panels: ReadonlyArray<ReadonlyArray<[number, number]>>,
  /** The page with its words, which are drawn one by one over its picture; none where it has no words. */
  words: PageDocument | null,
  /** Its words in the order in which they appear. */
  said: ReadonlyArray<Said>,
  /** Where the camera stays, in order. The first and the last time it sees all of the page. */
  stops: ReadonlyArray<Stop>,
  /** How many frames a word takes to appear. */
  fade: number,
};

/** A word that appears. */
export type Said = {
  /** Its place among the words of the page. */
  word: number,
  /** The panel that it is read with. */
  panel: number,
  /** The first frame in which it is seen. */
  from: number,
};

/** A place where the camera stays. */
export type Stop = {
  /** The panel that is read; none for the whole page. */
  panel: number | null,
  /** The first frame in which the camera is there. */
  from: number,
  /** The frame behind the last one. */
  to: number,
  /** What it sees at `from`, in fractions of the page's picture; it may reach beyond the page. */
  first: Crop,
  /** What it sees at its end. */
  last: Crop,
};

/** What is written before what is told. `{page}` and `{count}` stand for numbers. */
export type BoardLabels = {
  /** Before the scene. */
  scene: string,
  /** Before what is said. */
  dialogue: string,
  /** Before the notes. */
  notes: string,
  /** Which sheet it is of how many. */
  page: string,
};

/** A point of a photo, in parts of it. */
export type Focus = {
  /** From the left. */
  x: number,
  /** From the top. */
  y: number,
};

/** The order of photos. */
export type Order = "time" | "name";

/** Parts of the page that no shuffle changes. */
export type Locks = {
  /** The layout. */
  layout: boolean,
  /** The style. */
  style: boolean,
  /** The photos. */
  photos: boolean,
};

/** How a shuffle draws a style. */
export type Styling = {
  /** The share of invented ones, 0 to 1. */
  invented: number,
  /** The line layer stays. */
  keepLines: boolean,
  /** The colour layer stays. */
  keepColours: boolean,
};

/** A page of a storyboard. */
export type Sheet = {
  /** The page. */
  page: PageDocument,
  /** Names the version. */
  pageId: number,
  /** Names its place through all its versions. */
  sheet: number,
};

/**
 * A style while it is designed. Every block has a key, so that its card stays the same card wherever it is moved, and all
 * of its values.
 */
export type Draft = {
  /** Id of the style. */
  id: string,
  /** What people call it. */
  name: string,
  /** Families that it belongs to. */
  tags: ReadonlyArray<string>,
  /** The colour layer. */
  background: ReadonlyArray<DraftStep>,
  /** The line layer. */
  foreground: ReadonlyArray<DraftStep>,
  /** Colour of the lines, `#rrggbb`. */
  ink: string,
  /** Whether it takes no care of faces. */
  careless?: boolean,
  /** The parts of the picture that the layers are for. */
  where?: LayerParts,
};

/** A block of a draft. */
export type DraftStep = {
  /** Names it within the draft. */
  key: number,
  /** What runs. */
  block: string,
  /** Its values by the ids of the parameters. */
  values: Record<string, ParamValue>,
  /** Left out of the chain. */
  bypass: boolean,
  /** The part of the picture that it is for; all of it where none is told. */
  where?: StylePart,
};

/** A layer of a style. */
export type Layer = "background" | "foreground";

/** Where something is done. */
export type Place = {
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
};

/** What is done to a draft. In JSON an object with the edit's name as its `type`, beside its fields and those of its place. */
export type DraftEdit = { "type": "add",
  /** Ids of blocks. */
  blocks: ReadonlyArray<string>,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "move",
  /** The layer that it goes to. */
  toLayer: Layer,
  /** Its place there; the end where that is beyond it. */
  to: number,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "remove",
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "duplicate",
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "bypass",
  /** Whether it is left out. */
  on: boolean,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "set",
  /** Its id. */
  param: string,
  /** The value. */
  value: ParamValue,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "where",
  /** For all of it where it is null. */
  part: StylePart | null,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "layer-where",
  /** Which layer. */
  layer: Layer,
  /** For all of it where it is null. */
  part: StylePart | null,
}
| { "type": "reset",
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "name",
  /** It. */
  name: string,
}
| { "type": "faces",
  /** Whether it does. */
  on: boolean,
}
| { "type": "ink",
  /** `#rrggbb`. */
  ink: string,
};

/** What is known of a draft. */
export type DraftFacts = {
  /** Its file. */
  style: Style,
  /** The same with blocks passed over that cannot work where they are. */
  shown: Style,
  /** Whether all can. */
  whole: boolean, background: LayerFacts, foreground: LayerFacts,
};

/** What is known of a layer of a draft. */
export type LayerFacts = {
  /** Of each of its blocks, */
  misfits: ReadonlyArray<Misfit | null>,
  /** and by its id of each block that could come behind them. */
  brings: Record<string, Misfit | null>,
};

/** What a block needs and does not get. */
export type Misfit = { lacks: Lack,
  /** The block that gives it. */
  remedy: string,
};

/** What a block needs and does not get. */
export type Lack = "luma" | "color";

/** A page that was shown. */
export type Shown = {
  /** Names it. */
  id: number,
  /** Its last state. */
  page: PageDocument,
  /** The page that it was made from. */
  from?: number,
  /** Its place in the storyboard; 0 in a project of one page. */
  sheet?: number,
};

/** The states of a project. */
export type History = {
  /** The oldest first. */
  past: ReadonlyArray<Project>,
  /** The state now. */
  present: Project,
  /** The next first. */
  future: ReadonlyArray<Project>,
  /** The pages shown, in the order in which they came. */
  shown: ReadonlyArray<Shown>,
};

/** What is done. In JSON an object with the edit's name as its `type`, beside its fields. */
export type Edit = { "type": "add-photos",
  /** Their ids. */
  ids: ReadonlyArray<string>,
}
| { "type": "remove-photos",
  /** Their ids. */
  ids: ReadonlyArray<string>,
}
| { "type": "forget-photos",
  /** Their ids. */
  ids: ReadonlyArray<string>,
}
| { "type": "use-photos",
  /** Which, by id. */
  uses: Record<string, boolean>,
}
| { "type": "exchange-photo",
  /** The one that goes. */
  id: string,
  /** The one that comes. */
  by: string,
}
| { "type": "choose-by",
  /** Bits in which fingerprints of look-alikes may differ. */
  alike?: number | null,
  /** The order. */
  order?: Order | null,
}
| { "type": "focus-photo",
  /** The photo. */
  id: string,
  /** None takes the mark away. */
  focus: Focus | null,
}
| { "type": "star-photo",
  /** The photo. */
  id: string,
  /** Whether it is starred. */
  on: boolean,
}
| { "type": "mask-photo",
  /** The photo. */
  id: string,
  /** None goes back to what was found. */
  mask: string | null,
  /** That, for the figures of the photo that step out of their panels. */
  found?: string,
}
| { "type": "describe-shots",
  /** All that is told of each, by the ids of the photos. */
  shots: Record<string, Shot>,
}
| { "type": "set-board",
  /** All that is told of that. */
  board: Board,
}
| { "type": "lock",
  /** Which. */
  part: Part,
  /** Whether it is locked. */
  on: boolean,
}
| { "type": "want-panels",
  /** None for any. */
  count: number | null,
}
| { "type": "show-page",
  /** It. */
  page: PageDocument,
  /** Names it among those shown. */
  pageId: number,
}
| { "type": "change-page",
  /** What it is now. */
  page: PageDocument,
}
| { "type": "change-settings",
  /** The settings. */
  settings: PageSettings,
  /** The page; none where there is none. */
  page: PageDocument | null,
}
| { "type": "set-sheets",
  /** In order, one at least. */
  sheets: ReadonlyArray<Sheet>,
  /** Which is edited from now on. */
  at: number,
}
| { "type": "add-words",
  /**
   * Each with the place of its page as `sheet` and its `panel`, or with its `photo`; `joins` those that go on with what the
   * one before says.
   */
  words: ReadonlyArray<Word & { sheet?: number; joins?: boolean }>,
}
| { "type": "drop-waiting",
  /** Their numbers. */
  words: ReadonlyArray<number>,
}
| { "type": "no-page" }
| { "type": "design",
  /** None where nothing is. */
  draft: Draft | null,
}
| { "type": "own-styles",
  /** All of them. */
  mine: ReadonlyArray<Style>,
}
| { "type": "favourites",
  /** All of them. */
  favourites: ReadonlyArray<Style>,
}
| { "type": "own-layouts",
  /** All of them. */
  ownLayouts: ReadonlyArray<Template>,
}
| { "type": "love-page",
  /** Its id. */
  pageId: number,
  /** Whether it is. */
  on: boolean,
}
| { "type": "rename",
  /** What the person calls it. */
  name: string,
}
| { "type": "styling",
  /** What is told of that. */
  styling: Styling,
}
| { "type": "undo" }
| { "type": "redo" }
| { "type": "share",
  /** Those that changed. */
  lists: Partial<SharedLists>,
}
| { "type": "join",
  /** Those that there are. */
  lists: Partial<SharedLists>,
};

/** A part of the page. */
export type Part = "layout" | "style" | "photos";

/** How an edit counts: fields beside those of the edit. */
export type How = {
  /** It amends the present without a step, as for a page that is still growing. */
  silent?: boolean,
  /**
   * Names the edit that it belongs to, such as one drag of a slider: a step with the gesture of the step before joins
   * it.
   */
  gesture?: string,
};

/** A storyboard page. */
export type PageDocument = {
  /** `VERSION`. */
  version: number,
  /** Seed of the shuffle that made it. */
  seed: number,
  /** Id of a layout, or a template in full. */
  layout: LayoutChoice,
  /** Id of a style, or a style in full. */
  style: StyleChoice,
  /** Photos in reading order; there may be more than panels. */
  order: ReadonlyArray<string>,
  /** What each panel shows, in paint order. */
  panels: ReadonlyArray<PanelUse>,
  /** Groups of panels that share one image. */
  merges: ReadonlyArray<ReadonlyArray<number>>,
  /** Size, gutters and colours. */
  page: PageSettings,
  /** The photos get one white point. Pages that were saved before this field have the colours of each photo. */
  balanced?: boolean,
  /** Words on the page, as `Word`(super::words::Word) has them, in paint order. Whoever draws them checks them. */
  words: ReadonlyArray<Word>,
};

/** What one panel shows. */
export type PanelUse = {
  /** Id of the photo; none leaves the panel empty. */
  photo: string | null,
  /** The part of the photo that fills the panel, or the group it is merged into. */
  crop: Crop | null,
  /** Faces of the photo, in fractions of it, which the style takes care of. Pages of before have none, and look as they did. */
  faces?: ReadonlyArray<Crop>,
  /** The subject of the photo, which steps out of the panel where there is room; none, and nothing does. */
  figure?: string,
  /** The picture is shown as it is: in no style, without a border, and it is told as a logo. */
  plain?: boolean,
  /** Kept by every shuffle. */
  locked?: boolean,
  /** The crop was made by hand: it stays while the photo stays in this panel. */
  edited?: boolean,
};

/** A layout by its id, or in full. */
export type LayoutChoice = string | Template;

/** A style by its id, or in full. */
export type StyleChoice = string | Style;

/** The settings of one page. Lengths are fractions of the page's width unless a unit is given. */
export type PageSettings = {
  /** Width of the exported page in pixels, 64..=14000. */
  width: number,
  /** Height of the exported page in pixels, 64..=14000. */
  height: number,
  /** Pixels an inch that the file announces to a printer, 36..=1200. */
  dpi: number,
  /** Distance between two panels, 0..=0.1. */
  gutter: number,
  /** Distance between the panels and the edge of the page, 0..=0.2. */
  margin: number,
  /** Width of the line round a panel, 0..=0.05. */
  border: number,
  /** Radius of the panels' corners, 0..=0.2. */
  cornerRadius: number,
  /** Colour of the paper, `#rrggbb`. */
  paper: string,
  /** Colour of the line round a panel, `#rrggbb`. */
  borderColor: string,
  /** Text is set for screens, where it is larger than in print. */
  forScreens?: boolean,
  /** How far what ends at the edge goes on beyond it, 0..=0.1: for a file that is printed and cut, never saved. */
  bleed?: number,
  /** Photos that have fewer than `COARSE` pixels an inch are enlarged well: for a file that is printed, never saved. */
  enlarge?: boolean,
};

/** The part of a photo that a panel shows, in fractions of the oriented photo. It lies inside the photo. */
export type Crop = {
  /** Left edge, 0..1. */
  x: number,
  /** Top edge, 0..1. */
  y: number,
  /** Width, 0..1. */
  width: number,
  /** Height, 0..1. */
  height: number,
};

/**
 * A caption, a balloon or a sound effect; what is left out is usual. Places are fractions of the bounds of its panel, or
 * of the page where it has none.
 */
export type Word = { kind: 'caption' | 'balloon' | 'effect',
  /** What it says. */
  text: string,
  /** The outline of a balloon. */
  shape?: 'oval' | 'thought' | 'shout' | 'whisper' | 'radio',
  /** The panel that it stands on. */
  panel?: number | null, x?: number, y?: number,
  /** Width in page widths; null fits the text. */
  width?: number | null,
  /** Height of an em in page widths; `auto` or null fits the text. */
  size?: number | 'auto' | null,
  /** Where the tail of a balloon points. */
  tail?: Focus | null,
  /** Id of a font. */
  font?: string,
  /** Colour of the letters. */
  color?: string,
  /** Colour of the box. */
  fill?: string,
  /** Degrees that an effect is turned clockwise. */
  angle?: number,
  /** How far the line of an effect bends, -1 to 1. */
  arc?: number,
  /** Nobody has moved it: it goes where it hides no face. */
  auto?: boolean,
  /** Shuffle made it: the next shuffle replaces it. */
  made?: boolean,
  /** The photo that it belongs to: it goes wherever that is. Null names the one on its panel. */
  photo?: string | null,
  /** The subtitle that it was made of: none is added twice. */
  cue?: string | null,
  /**
   * The conventions that it follows: 2 are those of letterers, which new words get; words without are those of
   * earlier pages, and look as they did.
   */
  craft?: 1 | 2,
  /** A caption without a box. */
  boxless?: boolean,
  /** Whether it is set in capitals; null is as its conventions have it. */
  capitals?: boolean | null,
  /** Degrees that the letters of an effect lean to the right, -45 to 45. */
  slant?: number,
  /** Half the width of the line around the letters of an effect, in ems, 0 to 0.4; null is as usual. */
  outline?: number | null,
  /** An effect that stands behind the figures. */
  behind?: boolean,
  /** Its name, for those that are joined to it. */
  id?: string | null,
  /** The name of the balloon that this one is joined to. */
  joined?: string | null,
  /** The same, found when the balloon was placed by itself. */
  linked?: string | null,
  /** It is joined to no balloon by itself. */
  apart?: boolean,
  /** Who says it, where that is known. */
  by?: string,
  /** The language of its text: long words part by its rules. */
  language?: string | null,
  /** Its lines are columns, read from the top down and from right to left. */
  vertical?: boolean,
  /** Width and height in page widths that it keeps to, found when it was placed. */
  room?: readonly [width: number, height: number] | null,
};

/** Where a word is without its tail, in page widths. */
export type WordBox = {
  /** Left edge. */
  x: number,
  /** Top edge. */
  y: number,
  /** Width. */
  width: number,
  /** Height. */
  height: number,
  /** Where its tail ends. */
  tip: Point | null,
  /** Height of an em. */
  size: number,
  /** The end of its text found no room. */
  cut: boolean,
  /** Colour of its letters, `#rrggbb`. */
  color: string,
  /** Colour inside of its outline, or around its letters. */
  fill: string,
  /** Id of its font. */
  font: string,
};

/** A page template that has passed every check of its schema (see `layouts/README.md`). */
export type Template = { id: string, name: string, family: string, aspect: number, order?: ReadonlyArray<number>, weights?: ReadonlyArray<number>,
} & ({ "tree": string | object }
| { "polygons": ReadonlyArray<ReadonlyArray<Point>> });

/** A style: a background layer and, where there is one, a foreground layer of lines. */
export type Style = {
  /** Name for programs. */
  id: string,
  /** Name for people. */
  name: string,
  /** Families it belongs to; the first is the main one. */
  tags: ReadonlyArray<string>,
  /** The colour layer. Empty means the photo as it is. */
  background: ReadonlyArray<StyleStep>,
  /** The line layer; its luma is the alpha of the background over the ink. */
  foreground?: ReadonlyArray<StyleStep>,
  /** The parts of the picture that the layers are for. */
  where?: LayerParts,
  /** Colour of the lines. */
  ink?: string,
  /** Whether it takes care of faces, as a style does that does not say otherwise. */
  faces?: boolean,
  /** Score from 0 to 1 of a generated style. */
  score?: number,
};

/** One block of a layer with its values. */
export type StyleStep = { block: string; bypass?: boolean; where?: StylePart } & Record<string, ParamValue>;

/** What is asked for. The answer depends on nothing else. */
export type Request = {
  /** Seed of every choice that is left to chance. */
  seed: number,
  /** Photos in use, in order of time. */
  photos?: ReadonlyArray<PhotoMeta>,
  /** Size, gutters and colours of the page. */
  page?: PageSettings,
  /** The page as it is; none when there is none yet. */
  current?: PageDocument | null,
  /** Parts of the page that stay. */
  keep?: Keep,
  /** A layout to take, by id or in full. */
  layout?: LayoutChoice | null,
  /** A style to take, by id or in full. */
  style?: StyleChoice | null,
  /** How a style is drawn that is left to chance. */
  styling?: StylingRequest,
  /** A layout that a free page takes unless another is clearly better. */
  prefer?: LayoutChoice | null,
  /** Wanted number of panels where the layout is free. */
  panels?: number | null,
  /** How photos that do not stay are chosen. */
  mode?: Mode,
  /** Whether the photos stay in their order along the page. Default: whether all are dated, at different times. */
  ordered?: boolean | null,
  /**
   * The photos of pages that were shown before, by id: the photo of the largest panel first, the last page last. Photos
   * that they do not show have their turn.
   */
  recent?: ReadonlyArray<ReadonlyArray<string>>,
  /**
   * Whether a new layout gets panels that share one image: always, never, or, where nothing is said, by chance.
   * Chance has no say in a layout or a number of panels that was asked for: each panel then has its own image.
   */
  merge?: boolean | null,
  /** Exactly these groups of panels share one image each. */
  merges?: ReadonlyArray<ReadonlyArray<number>> | null,
  /**
   * Whether a figure steps out of its panel, where the masks of the photos are there and one can: always, never, or, where nothing
   * is said, by chance.
   */
  figures?: boolean | null,
  /** What the person liked so far. */
  taste?: Taste,
  /** Families that chance keeps to. */
  within?: Families,
  /** What was shown just now and is not to come again at once, beside what the current page has. */
  avoid?: Avoid,
  /** How bold the draw is: 1 as usual, more to be surprised more, 0 for the best that was found. */
  surprise?: number | null,
};

/** Parts of the current page that stay. */
export type Keep = {
  /** The layout. */
  layout?: boolean,
  /** The style. */
  style?: boolean,
  /** The photos and their order. */
  photos?: boolean,
};

/** How photos that do not stay are chosen. */
export type Mode = "shuffle" | "photos";

/**
 * What a person liked so far, as the natural logarithm of what it does to the weights of families and styles. As JSON
 * `{families: {ID: NUMBER}, styles: {ID: NUMBER}}`, each of which may be missing; what is no number says nothing.
 */
export type Taste = {
  /** By family of layouts. */
  families?: { [key in string]: number },
  /** By id of a style. */
  styles?: { [key in string]: number },
};

/** Layouts and styles that were shown just now, by id. */
export type Avoid = {
  /** Layouts. */
  layouts?: ReadonlyArray<string>,
  /** Styles. */
  styles?: ReadonlyArray<string>,
};

/**
 * Families that chance keeps to, any where a list is empty: of layouts, `FAMILIES`(crate::layout::FAMILIES), and of styles,
 * `FAMILIES`(crate::style::catalogue::FAMILIES). What is asked for by id is not held to them.
 */
export type Families = {
  /** Of layouts. */
  layouts?: ReadonlyArray<string>,
  /** Of styles. */
  styles?: ReadonlyArray<string>,
};

/** How a style is drawn. As JSON `{extra, invented, inventions, keepLines, keepColours}`, each of which may be missing. */
export type StylingRequest = {
  /** Styles in full that are drawn like the designed ones: a person's own and favourites. */
  extra?: ReadonlyArray<Style>,
  /** Share of draws, 0 to 1, that invent a style. */
  invented?: number,
  /** Invented styles that were tried and found good: only these are drawn where the list is there, however short it is. */
  inventions?: ReadonlyArray<Style>,
  /** The line layer and its ink stay. */
  keepLines?: boolean,
  /** The colour layer stays. */
  keepColours?: boolean,
};

/** Facts about a photo, measured once at import. All positions are fractions of the oriented photo. */
export type PhotoMeta = {
  /** Unique name within the album. */
  id: string,
  /** Width of the oriented original, in pixels. */
  width: number,
  /** Height of the oriented original, in pixels. */
  height: number,
  /** The 64-bit fingerprint; 16 hexadecimal digits in JSON. */
  fingerprint: string,
  /** Sharpness by the default metric; comparable within an album only. */
  sharpness: number,
  /** Where the photo has something to see. */
  energy: EnergyMap,
  /** When it was taken, `YYYY:MM:DD HH:MM:SS`, where the file says so. */
  taken: string | null,
  /** Lettering, and the faces and objects found in it once detection has run. */
  subjects: ReadonlyArray<Subject>,
  /** The point that a person marked as the one that matters. */
  focus: Focus | null,
  /** Tones, texture and colour; none where the photo was never measured, as in projects of before. */
  facts?: string,
  /** Which part of it is its subject, once that was looked for. */
  mask?: string,
  /** Marked by a person as one that matters: it gets the large panel. */
  starred?: boolean,
};

/** An energy map as JSON has it: two hexadecimal digits a cell. */
export type EnergyMap = { columns: number, rows: number, values: string,
};

/** A detected face or object. */
export type Subject = {
  /** Left edge, 0..1. */
  x: number,
  /** Top edge, 0..1. */
  y: number,
  /** Width, 0..1. */
  width: number,
  /** Height, 0..1. */
  height: number,
  /** `FACE` or the name of an object. */
  label: string,
  /** The detector's confidence, 0..1. */
  score: number,
};

/** A filter block, as the page makes its controls of it. */
export type Block = {
  /** Name in style files. */
  id: string,
  /** Name for people. */
  label: string,
  /** What it does, in one line. */
  help: string,
  /** What it takes. */
  input: Channels,
  /** What it gives. */
  output: Channels,
  /** Its parameters. */
  params: ReadonlyArray<BlockParam>,
};

/** A parameter of a block. */
export type BlockParam = {
  /** Key in a style file. */
  id: string,
  /** Name of the control. */
  label: string,
  /** One line for people. */
  help: string,
  /** What it is. */
  kind: ParamKind,
  /** Used where a style file says nothing. */
  default: ParamValue,
  /** Smallest value of a number. */
  min?: number,
  /** Its largest value. */
  max?: number,
  /** Step of its slider. */
  step?: number,
  /** Sign behind it. */
  unit?: string,
  /** The names to choose from. */
  choices?: ReadonlyArray<string>,
};

/** What a parameter is. */
export type ParamKind = "number" | "integer" | "boolean" | "choice" | "texture" | "colour";

/** Which images a block takes or gives. */
export type Channels = "luma" | "color" | "any";

/** A part of a picture. */
export type StylePart = "subject" | "background";

/** The parts that the layers of a style are for; all of the picture where none is told. */
export type LayerParts = {
  /** That of the colours: the photo stays as it is elsewhere. */
  background?: StylePart,
  /** That of the lines: there are none elsewhere. */
  foreground?: StylePart,
};

/** What the list of layouts shows of a template, in unit coordinates. */
export type Layout = {
  /** Unique name in kebab-case. */
  id: string,
  /** What people call it. */
  name: string,
  /** Its family. */
  family: string,
  /** Width over height of the page that it was drawn for. */
  aspect: number,
  /** Panels. */
  count: number,
  /** In the order in which they are painted. */
  panels: ReadonlyArray<LayoutPanel>,
};

/** A panel of a template. */
export type LayoutPanel = {
  /** Its outline. */
  shape: Outline,
  /** How much it draws the eye. */
  weight: number,
  /** It lies on top of others. */
  overlay: boolean,
};

/** The outline of a panel: one of both. */
export type Outline = {
  /** Corners; the first is joined to the last. */
  polygon?: ReadonlyArray<Point>,
  /** A circle. */
  circle?: Circle,
};

/** A circle. */
export type Circle = {
  /** Its centre from the left. */
  x: number,
  /** Its centre from the top. */
  y: number,
  /** Its radius. */
  radius: number,
};

/** A layout in the list. */
export type LayoutEntry = {
  /** Unique name in kebab-case. */
  id: string,
  /** What people call it. */
  name: string,
  /** Its family. */
  family: string,
  /** Panels. */
  count: number,
  /** Its place among a person's own; null for one of the catalogue. */
  own: number | null,
  /** Its panels as an SVG path on a page 1000 wide. */
  base: string,
  /** Its overlays likewise. */
  over: string,
};

/** What can be done to a layout on a page. */
export type LayoutFacts = {
  /** Unique name in kebab-case. */
  id: string,
  /** What people call it. */
  name: string,
  /** Its family. */
  family: string,
  /** Panels. */
  count: number,
  /** Panels below overlays. */
  base: number,
  /** It suits the page. */
  good: boolean,
  /** It is made of cuts. */
  editable: boolean,
  /** Pairs of panels with a common edge. */
  adjacent: ReadonlyArray<[number, number]>,
  /** The cuts between panels. */
  cuts: ReadonlyArray<Cut>,
};

/** A cut of a template on a page. */
export type Cut = {
  /** Which way the cells that it parts are laid out: it runs across for rows, down for columns. */
  axis: Axis,
  /** Its left or upper end, in page widths. */
  from: Point,
  /** Its right or lower end, in page widths. */
  to: Point,
  /** Where it lies in its cell, 0..1. */
  fraction: number,
  /** Its slant, as in the file. */
  slant: number,
  /**
   * The extent of its cell along the way that it can move, in page widths: moved by `d` page widths, its
   * fraction changes by `d / length`.
   */
  length: number,
};

/** Which way a split runs. */
export type Axis = "rows" | "columns";

/** A change to a layout by hand. */
export type LayoutChange = { "type": "move-cut",
  /** Its place among the cuts. */
  cut: number,
  /** Where it lies in its cell, 0..1. */
  fraction: number,
  /** As in the file. */
  slant: number,
}
| { "type": "split",
  /** Which. */
  panel: number,
  /** Which way they lie. */
  axis: Axis,
}
| { "type": "remove",
  /** Which. */
  panel: number,
}
| { "type": "join",
  /** Which. */
  panels: ReadonlyArray<number>,
};

/** What the list of layouts is asked. */
export type LayoutsRequest = {
  /** The page that they are for. */
  page: PageSettings,
  /** A person's own. */
  own?: ReadonlyArray<Template>,
};

/** What a new layout is to be like. */
export type GenerateRequest = {
  /** Of all that is left to chance. */
  seed: number,
  /** The page that it is for. */
  page: PageSettings,
  /** Panels at least, */
  least: number,
  /** and at most. */
  most: number,
};

/** Where the panels are on a page whose width is 1, gutters and margins applied. */
export type Geometry = {
  /** 1. */
  width: number,
  /** Height over width. */
  height: number,
  /** In the order in which they are painted. */
  panels: ReadonlyArray<PlacedPanel>,
  /** The numbers of the panels in reading order. */
  order: ReadonlyArray<number>,
};

/** A panel on the page, in page widths; its outline is one of both. */
export type PlacedPanel = {
  /** Corners; the first is joined to the last. */
  polygon?: ReadonlyArray<Point>,
  /** A circle. */
  circle?: Circle,
  /** The rectangle round the outline. */
  bounds: Bounds,
  /** It lies on top of others. */
  overlay: boolean,
  /** Width of the paper-coloured ring outside the outline; 0 when there is none. */
  halo: number,
};

/** A rectangle with sides parallel to the axes. */
export type Bounds = {
  /** Left edge. */
  x: number,
  /** Top edge. */
  y: number,
  /** Width, at least 0. */
  width: number,
  /** Height, at least 0. */
  height: number,
};

/** A point, or a vector, in the plane; y grows downward. */
export type Point = [number, number];

/** The selection's word on a photo. */
export type Verdict = {
  /** Of the photo. */
  id: string,
  /** Number of its group of look-alikes. */
  group: number,
  /** Whether it is used. */
  kept: boolean,
  /** In a few words. */
  why: string,
};

/** What is asked of the selection. */
export type ChoiceRequest = {
  /** All photos. */
  photos: ReadonlyArray<Candidate>,
  /** Bits in which fingerprints of look-alikes may differ. */
  threshold?: number,
};

/** A photo that may be worth a panel. */
export type Candidate = {
  /** Its id. */
  id: string,
  /** What people call it. */
  name: string,
  /** See `MeasuresEntry`. */
  fingerprint: string,
  /** See `MeasuresEntry`. */
  gradient: number,
  /** See `MeasuresEntry`. */
  paper: number,
  /** See `MeasuresEntry`. */
  laplacian: number,
  /** The film that it is a frame of. */
  film?: string | null,
};

/** What selection compares, as JSON has it. */
export type Measures = {
  /** The 64-bit fingerprint in 16 hexadecimal digits. */
  fingerprint: string,
  /** Sharpness, comparable between photos that show the same. */
  gradient: number,
  /** How much of it is paper. */
  paper: number,
  /** Sharpness, comparable across an album. */
  laplacian: number,
};

/** What the page is told of a photo that was read. */
export type ImportEntry = {
  /** What framing knows of it. */
  meta: PhotoMeta,
  /** Name of the file's format. */
  format: string,
  /** The damage of the file, if any. */
  damage: Damage | null,
  /** What selection compares. */
  measures: Measures,
  /** Size of the photo at `WORK_SIDE` or less. */
  work: PixelSize,
  /** Size of the photo at `SMALL_SIDE` or less. */
  small: PixelSize,
};

/** A size in pixels. */
export type PixelSize = {
  /** Across. */
  width: number,
  /** Down. */
  height: number,
};

/** Damage of a file that was decoded nevertheless. */
export type Damage = {
  /** Share of the picture that is missing and drawn grey, from 0 to 1. */
  missing: number,
  /** Share of the picture that lacks detail, from 0 to 1. */
  coarse: number,
};

/** Something that was found in a photo. Its box lies inside the photo. */
export type Detection = {
  /** `face`, or one of COCO's eighty kinds of objects. */
  label: string,
  /** The detector's confidence, 0..1. */
  score: number,
  /** Left edge, 0..1. */
  x: number,
  /** Top edge, 0..1. */
  y: number,
  /** Width, 0..1. */
  width: number,
  /** Height, 0..1. */
  height: number,
};

/** What the first look for faces found. */
export type FirstLook = {
  /** The faces. */
  boxes: ReadonlyArray<Detection>,
  /** Whether a closer look may find more. */
  closer: boolean,
};

/** A sound of a film. */
export type SoundEvent = {
  /** Seconds at which it begins */
  start: number,
  /** and ends. */
  end: number,
  /** What it is like. */
  kind: SoundKind,
  /** Of its loudest frame, of music on average, in whole dB below full scale: -42 to about 0. */
  loudness: number,
  /** Words that it may be written with, the best first. */
  words: [SoundWord, SoundWord, SoundWord],
};

/** What a sound is like. */
export type SoundKind = "hit" | "sweep" | "music";

/** Names of words of sound, which languages write as they do. */
export type SoundWord = "bang" | "boom" | "clang" | "clap" | "click" | "clink" | "crack" | "crash" | "ding" | "knock" | "note" | "notes" | "rumble" | "slam" | "snap" | "swish" | "tap" | "thud" | "thump" | "tick" | "tune" | "vroom" | "whoosh" | "zip" | "zoom";

/** What is asked for a child of two styles. */
export type BreedRequest = { a: StyleChoice, b: StyleChoice, seed: number,
  /** 0 to 1. */
  surprise: number,
};

/** The tables that states name their parts of. */
export type Tables = { items: ReadonlyArray<TrayItem>, trays: ReadonlyArray<ReadonlyArray<number>>, pages: ReadonlyArray<PageDocument>, sheets: ReadonlyArray<KeptSheet>, books: ReadonlyArray<ReadonlyArray<number>>, styles: ReadonlyArray<Style>, shelves: ReadonlyArray<ReadonlyArray<number>>, layouts: ReadonlyArray<Template>, layoutShelves: ReadonlyArray<ReadonlyArray<number>>, settings: ReadonlyArray<PageSettings>, drafts: ReadonlyArray<Draft>, words: ReadonlyArray<Word>, waits: ReadonlyArray<ReadonlyArray<number>>, boards: ReadonlyArray<Board>,
};

/** What an edit changed: `difference` in `src/document/kept.rs` says how it is read. */
export type Difference = {
  /** As the one of that number was, but for these fields. */
  states: ReadonlyArray<[of: number, fields: Partial<KeptState>]>, past: Runs, present: number, future: Runs, entries: ReadonlyArray<KeptShown>, shown: Runs, parts: Tables,
  /** An id for a new page, */
  pageId: number,
  /** and one for a new place. */
  sheet: number,
};

/** The storyboard after photos went out of use. */
export type RepairedSheets = {
  /** In order; a page that stays as it was is left out. */
  sheets: ReadonlyArray<Omit<Sheet, 'page'> & Partial<Pick<Sheet, 'page'>>>,
  /** Which is edited. */
  at: number,
};

/** A history that was put into an editor. */
export type Loaded = {
  /** What was left out, as sentences. */
  dropped: ReadonlyArray<string>,
  /** An id for a new page, */
  pageId: number,
  /** and one for a new place. */
  sheet: number,
};

/** A history with tables of its parts. */
export type TabledHistory = { parts: Tables, past: ReadonlyArray<KeptState>, present: KeptState, future: ReadonlyArray<KeptState>, shown: ReadonlyArray<KeptShown>,
};

/** A history out of the database, checked. */
export type ReadHistory = { version: number, history: TabledHistory,
  /** What was left out, as sentences. */
  dropped: ReadonlyArray<string>,
};

/** A project file or the text of a page, checked. */
export type ReadProject = { format: string, version: number, history: { present: Project; shown: ReadonlyArray<Shown> }, photos: ReadonlyArray<FilePhoto>, videos: ReadonlyArray<FileVideo>,
  /** What was left out, as sentences. */
  dropped: ReadonlyArray<string>,
};

/** What a file tells of a photo. */
export type FilePhoto = {
  /** Its id in the document. */
  id: string,
  /** The name of its file. */
  name: string,
  /** Its place in the archive. */
  path: string,
  /** The type of its file, empty where nobody knows it. */
  type: string,
  /** Its author. */
  credit?: string,
  /** The video that it is a frame of. */
  video?: string,
  /** Seconds from the beginning of the video. */
  time?: number,
  /** The number of its shot in the video, from 1. */
  shot?: number,
  /** Whether it is compared with other photos. */
  measured: boolean,
  /** What was found in it; none when it was not searched. */
  subjects: ReadonlyArray<Subject> | null,
  /** Which part of it is its subject. */
  mask?: string,
  /** Its place in time among the photos. */
  rank: number | null,
  /** How it is recognised where its file is not at hand. */
  like: Likeness | null,
  /** An empty frame stands for it. */
  absent: boolean,
};

/** What a file tells of a video. */
export type FileVideo = {
  /** Names it. */
  key: string,
  /** The name of its file. */
  name: string,
  /** Its place in the archive. */
  path: string,
  /** The type of its file. */
  type: string,
  /** Photos that are frames of it. */
  ids: ReadonlyArray<string>,
  /** Seconds; none until the file was opened. */
  duration: number | null,
  /** Frames are taken from here, */
  start: number,
  /** to here. */
  end: number | null,
  /** The timecode of its first picture. */
  timecode?: StartTimecode,
};

/** How a photo is recognised. */
export type Likeness = {
  /** SHA-256 of its file, or empty. */
  hash: string,
  /** Its fingerprint. */
  fingerprint: string,
  /** Width in pixels. */
  width: number,
  /** Height in pixels. */
  height: number,
};

/** How a file is made of pages; nothing told gives one sheet a page, in colour, without marks. */
export type PdfOptions = {
  /** What the file is called where it is shown. */
  title?: string,
  /** Language of what stands in it, as a tag such as `pt-BR`; empty says nothing. */
  language?: string,
  /** Lines beyond the corners that say where to cut and fold. */
  marks?: boolean,
  /** How pages share sheets. */
  imposition?: Imposition | null,
  /**
   * Width and height in millimetres of the sheets that all is fitted to, upright or not; none makes sheets as large as
   * what is on them.
   */
  paper?: [number, number] | null,
  /** The ink whose plate this is, by its place in `inks`; none is for all colours. */
  plate?: number | null,
  /** The colours on white paper of the inks of plates, the strongest last. */
  inks?: ReadonlyArray<[number, number, number]>,
};

/** How pages share sheets. */
export type Imposition = "booklet" | "zine" | "2up" | "spreads";

/** Pages that become one file. */
export type Comic = {
  /** What it is called. */
  title: string,
  /** BCP 47, such as `en`; what a reader says itself is in that language where there is one, else in English. */
  language: string,
  /** The files that its pictures are. */
  picture: PictureKind,
  /** Its pages in order. */
  pages: ReadonlyArray<ComicPage>,
};

/** A page of a comic. */
export type ComicPage = {
  /** The page; its picture is as large as that. */
  document: PageDocument,
  /** What each panel shows, such as `two people and a dog`, in paint order; empty where nobody knows. */
  shows: ReadonlyArray<string>,
  /** Where pictures that move lie over that of the page, in fractions of it, in paint order. HTML alone shows them. */
  moving?: ReadonlyArray<Crop>,
};

/** A kind of picture. */
export type PictureKind = "png" | "jpeg" | "webp";

/**
 * A part of a file: text, or the picture of the page of that number, from 0. Behind those of all pages come the pictures that
 * move, page after page.
 */
export type Piece = string | number;

/** A file of an archive. */
export type ComicFile = {
  /** Its name, with the folders that it is in. */
  name: string,
  /** What is in it. */
  content: Piece,
};

/** A value of a parameter: a number, an entry of its choices, or whether it is on. */
export type ParamValue = number | string | boolean;

/** The lists that all projects have in common. They are a part of each project, so that undo reaches them. */
export type SharedLists = Pick<Project, 'mine' | 'favourites' | 'ownLayouts'>;

/** Numbers of things in a row. */
export type Runs = ReadonlyArray<readonly [first: number, count: number]>;

/** What of a state stands in tables, which it names by numbers. */
export type Tabled = 'tray' | 'settings' | 'page' | 'others' | 'draft' | 'board' | 'waiting' | 'mine' | 'favourites' | 'ownLayouts';

/** A state whose parts stand in tables. */
export type KeptState = Omit<Project, Tabled> & {
  [Field in Exclude<Tabled, 'board' | 'waiting'>]: number | Extract<Project[Field], null>;
} & { board?: number | null; waiting?: number };

/** A page of a storyboard, and one that was shown, whose page stands in a table. */
export type KeptSheet = Omit<Sheet, 'page'> & { page: number };
export type KeptShown = Omit<Shown, 'page'> & { page: number };

/** Codes of the errors of the core. */
export type ErrorCode =
| 'unknown-format'
| 'rare-colours'
| 'damaged'
| 'unsupported'
| 'too-large'
| 'buffer-size'
| 'invalid-style'
| 'invalid-layout'
| 'invalid-document'
| 'damaged-project'
| 'newer-project'
| 'too-large-project'
| 'invalid-bank'
| 'unknown-style'
| 'unknown-layout'
| 'missing-photo'
| 'no-photos'
| 'small-picture'
| 'blank-picture'
| 'plain-photo'
| 'cancelled'
| 'detector'
| 'encode';
