/** Types of all data between the app and the core. Generated from the types of the core by `cargo xtask bless types`. */

/** A state of a project. */
export type Project = {
  /** Project name, empty until the user sets it. */
  name: string,
  /** The photos, in the order in which they were added. */
  tray: ReadonlyArray<TrayItem>,
  /** Maximum fingerprint distance of near-duplicates, in bits of 64. */
  alike: number,
  /** How the photos are ordered. */
  order: Order,
  /** Parts of the page that no shuffle changes. */
  locks: Locks,
  /** Wanted number of panels; `None` for any. */
  panels: number | null,
  /** Size, gutters and colours. */
  settings: PageSettings,
  /** The style in the designer. */
  draft: Draft | null,
  /** Unplaced text items. They return with their photos. */
  waiting?: ReadonlyArray<Word>,
  /** Custom styles, which all projects share. */
  mine: ReadonlyArray<Style>,
  /** Styles that are favourites, which all projects share. */
  favourites: ReadonlyArray<Style>,
  /** Custom layouts, which all projects share. */
  ownLayouts: ReadonlyArray<Template>,
  /** Favourite pages of the page history, by id. */
  loved: ReadonlyArray<number>,
  /** How a shuffle draws styles. */
  styling: Styling,
  /** Settings of the storyboard: frame rate, order and sheets. Not written if they equal the defaults. */
  board?: Board | null,
  /** The page that is edited; `None` without pages. */
  page: PageDocument | null,
  /** Id of the page in the page history. */
  pageId: number,
  /** Names its place in the storyboard through all its versions. */
  sheet: number,
  /** The other pages of the storyboard, in order. */
  others: ReadonlyArray<Sheet>,
  /** Number of pages before the current page. */
  at: number,
};

/** A photo in the tray. */
export type TrayItem = {
  /** Its id. */
  id: string,
  /** The user's choice; `None` follows the selection. */
  use: boolean | null,
  /** The focus point that the user set. */
  focus?: Focus | null,
  /** Whether the user starred it for a large panel. */
  starred?: boolean,
  /** The corrected subject mask. `None` uses the detected mask. */
  mask?: string,
  /** Shot metadata. */
  shot?: Shot,
};

/** Metadata of a shot. Empty fields are unset. */
export type Shot = {
  /** The scene that it belongs to. */
  scene?: string,
  /** A custom number, such as 4A. Without one the shot is numbered automatically. */
  number?: string,
  /** Action. */
  action?: string,
  /** Dialogue. */
  dialogue?: string,
  /** Captions. */
  caption?: string,
  /** Sounds. */
  sound?: string,
  /** Notes. */
  notes?: string,
  /** How long it is, in frames of the board's rate. */
  frames?: number,
  /** Values of custom columns by name. */
  more?: { [key in string]: string },
};

/** How the shots of a project are counted, ordered and laid out. */
export type Board = {
  /** Frames of a counted second, one of `RATES`. */
  fps: number,
  /** Timecode pace (real time or NTSC 1000/1001). Default: real time. */
  pace?: Pace,
  /** Names of custom columns, without duplicates. */
  columns: ReadonlyArray<string>,
  /** Frames on a sheet, one of `FRAMES`. */
  frames: number,
  /** The name of the frames' aspect, one of `ASPECTS`. */
  aspect: string,
  /** Whether the fields are next to the frames instead of under them. */
  beside: boolean,
  /** Whether ruled lines for handwriting replace the fields. */
  ruled: boolean,
  /** Who made it, for the head of the sheets. */
  author: string,
  /** Date in the header, as text. */
  date: string,
  /** Logo in the header: a PNG file as a data URL. Empty for no logo. */
  logo?: string,
  /** Photos that the user ordered. The other photos keep their automatic position. */
  order: ReadonlyArray<string>,
};

/** Shots in their order. In JSON, empty fields may be missing. */
export type ShotList = {
  /** Title of the album. */
  title: string,
  /** Frames per counted second, 1 to 60. Default: 24. */
  fps: number,
  /** Timecode pace. Default: real time. */
  pace?: Pace,
  /** Names of custom columns. */
  columns: ReadonlyArray<string>,
  /** Headings of the table, in the order of `HEADINGS`. English headings replace missing ones. */
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
  /** Action. */
  action: string,
  /** Dialogue. */
  dialogue: string,
  /** Captions. */
  caption?: string,
  /** Sounds. */
  sound?: string,
  /** Notes. */
  notes: string,
  /** Duration in frames. Default: two seconds. */
  frames?: number,
  /** Values of custom columns. */
  more: { [key in string]: string },
  /** File name of the photo. */
  name: string,
  /** The video, if the photo is a frame. */
  film?: Film,
};

/** A position in a video. */
export type Film = {
  /** Identifies the video, because others may have the same name. Without keys, videos with one name are one video. */
  key: string,
  /** The name of its file. */
  name: string,
  /** Seconds from the first frame. */
  time: number,
  /** Duration in seconds, if known. */
  length?: number,
  /** Timecode of the first frame. */
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

/** Request of storyboard sheets. In JSON, the fields of a `ShotList` are in the same object. */
export type BoardRequest = {
  /** The shots and the title. */
  list: ShotList,
  /** The image of each shot. */
  pictures: ReadonlyArray<BoardPicture>,
  /** Frames per sheet, 1 to 12. Default: 6. */
  frames: number,
  /** Width over height of the frames, 0.2 to 5. Default: 16:9. */
  aspect: number,
  /** Whether the fields are next to the frames instead of under them. */
  beside: boolean,
  /** Whether ruled lines replace the fields. */
  ruled: boolean,
  /** Who made it. */
  author: string,
  /** When. */
  date: string,
  /** Logo in the header of every sheet. */
  logo?: BoardLogo,
  /** Whether the paper is US Letter instead of A4. */
  letter: boolean,
  /** The style of the frames: an id, or a style in full. */
  style?: StyleChoice,
  /** Labels of the fields, in the language of the reader. */
  labels: BoardLabels,
};

/** The image of a shot. */
export type BoardPicture = {
  /** Id of the photo. */
  photo: string,
  /** The crop of the frame. */
  crop: Crop,
  /** Faces of the photo, which the style protects. */
  faces: ReadonlyArray<Crop>,
};

/** The logo in the headers. */
export type BoardLogo = {
  /** Photo id for the renderer. */
  photo: string,
  /** Its width over its height; it is shown with 1/30 to 30. */
  aspect: number,
};

/** Request of an animatic. */
export type AnimaticRequest = {
  /** The shots, and their frame rate. */
  list: ShotList,
  /** The image of each shot. */
  pictures: ReadonlyArray<AnimaticPicture>,
  /** Width and height of the frames in pixels, 64 to 3840. Rounded to even numbers, as encoders require. */
  size: [number, number],
  /** Frames per second, 1 to 60. Default: the rate of the list. */
  fps: number,
  /** Default duration of a shot in seconds. Default: 2. */
  seconds: number,
  /** Duration of a dissolve in seconds; 0 for hard cuts. */
  dissolve: number,
  /** Whether the camera moves. */
  moves: boolean,
  /** Whether dialogue, or else captions or action, is shown as a caption. */
  captions: boolean,
  /** Frames per second of animated panels from videos; 0 for stills. */
  living: number,
  /** The style: an id, or a complete style. */
  style?: StyleChoice,
};

/** The image of a shot. */
export type AnimaticPicture = {
  /** Id of the photo. */
  photo: string,
  /** The crop, with the aspect ratio of the frames. */
  crop: Crop,
  /** Faces of the photo, which the style protects. */
  faces: ReadonlyArray<Crop>,
  /** Detected subjects. The camera prefers faces, then people and animals, then things. */
  subjects: ReadonlyArray<Subject>,
};

/** Shots in their times. */
export type Animatic = {
  /** Frames of a counted second. */
  fps: number,
  /** Frames per second of real time. Lower than the frame rate for NTSC (23.976 instead of 24). */
  rate: number,
  /** Width and height of the frames in pixels. */
  size: [number, number],
  /** How many frames there are. */
  frames: number,
  /** Frames per second of animated panels, 0 without any. */
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
  /** First frame, including the dissolve from the shot before. */
  from: number,
  /** Index after the last frame, including the dissolve to the next shot. */
  to: number,
  /** View of the camera at `from`, in fractions of the image. Equal to `last` without a camera move. */
  first: Crop,
  /** View of the camera at the end. */
  last: Crop,
  /** The image as a page of one panel, large enough for the closest view. */
  picture: PageDocument,
  /**
   * An empty page of the frame size with only the caption, if the shot has one. The caption is centred,
   * its lower edge `Animatic::FOOT` above the lower edge of the frame.
   */
  caption: PageDocument | null,
  /** Reading order of a page, panel by panel; `None` for a shot. */
  reading: Reading | null,
};

/** Request of a motion comic. */
export type MotionRequest = {
  /** The pages in their order. */
  pages: ReadonlyArray<PageDocument>,
  /** Width and height of the frames in pixels, 64 to 3840. Rounded to even numbers, as encoders require. */
  size: [number, number],
  /** Frames per second, 1 to 60. */
  fps: number,
  /** Minimum duration of a panel in seconds; 0 for the default of two. */
  seconds: number,
  /** Duration of a dissolve between two pages in seconds; 0 for hard cuts. */
  dissolve: number,
  /** Whether the camera moves. If not, it jumps. */
  moves: boolean,
  /** Frames per second of animated panels from videos; 0 for stills. */
  living: number,
};

/** How a page is read. */
export type Reading = {
  /** The outline of each panel: corners, in fractions of the page's width and height. */
  panels: ReadonlyArray<ReadonlyArray<[number, number]>>,
  /** The page with its text items, which are drawn one by one over its image. Null without text. */
  words: PageDocument | null,
  /** Its text items in order of appearance. */
  said: ReadonlyArray<Said>,
  /** Stops of the camera, in order. The first and the last stop show the whole page. */
  stops: ReadonlyArray<Stop>,
  /** Number of frames in which a text item appears. */
  fade: number,
};

/** A text item that appears. */
export type Said = {
  /** Index of the text item on the page. */
  word: number,
  /** The panel that it is read with. */
  panel: number,
  /** The first frame in which it is seen. */
  from: number,
};

/** A stop of the camera. */
export type Stop = {
  /** The current panel; `None` for the whole page. */
  panel: number | null,
  /** The first frame in which the camera is there. */
  from: number,
  /** Index after the last frame. */
  to: number,
  /** View at `from`, in fractions of the page image. It may extend beyond the page. */
  first: Crop,
  /** View at the end. */
  last: Crop,
};

/** Labels of the fields. `{page}` and `{count}` are placeholders for numbers. */
export type BoardLabels = {
  /** Before the scene. */
  scene: string,
  /** Label of the dialogue. */
  dialogue: string,
  /** Label of captions. */
  caption?: string,
  /** Label of sounds. */
  sound?: string,
  /** Before the notes. */
  notes: string,
  /** Number of the sheet, and total number of sheets. */
  page: string,
};

/** A point of a photo, in fractions of its sides. */
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
  /** Display name. */
  name: string,
  /** Families that it belongs to. */
  tags: ReadonlyArray<string>,
  /** The colour layer. */
  background: ReadonlyArray<DraftStep>,
  /** The line layer. */
  foreground: ReadonlyArray<DraftStep>,
  /** Colour of the lines, `#rrggbb`. */
  ink: string,
  /** Whether face protection is off. */
  careless?: boolean,
  /** Whether pages in this style have dark paper. */
  dark?: boolean,
  /** The parts of the image that the layers apply to. */
  where?: LayerParts,
};

/** A block of a draft. */
export type DraftStep = {
  /** Names it within the draft. */
  key: number,
  /** Id of the block. */
  block: string,
  /** Its values by the ids of the parameters. */
  values: Record<string, ParamValue>,
  /** Whether the block is bypassed. */
  bypass: boolean,
  /** The part of the image that it applies to. `None`: the whole image. */
  where?: StylePart,
};

/** A layer of a style. */
export type Layer = "background" | "foreground";

/** Position of a block. */
export type Place = {
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
};

/**
 * An edit of a draft. In JSON, an object with the name of the edit as `type`, its fields and the fields of
 * its position.
 */
export type DraftEdit = { "type": "add",
  /** Ids of blocks. */
  blocks: ReadonlyArray<string>,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "move",
  /** The target layer. */
  toLayer: Layer,
  /** Index in the target layer, limited to its end. */
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
  /** Whether it is bypassed. */
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
  /** `null` for the whole image. */
  part: StylePart | null,
  /** The layer, */
  layer: Layer,
  /** and a position in it. */
  at: number,
}
| { "type": "layer-where",
  /** Which layer. */
  layer: Layer,
  /** `null` for the whole image. */
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
| { "type": "dark",
  /** Whether it is dark. */
  on: boolean,
}
| { "type": "ink",
  /** `#rrggbb`. */
  ink: string,
};

/** Analysis of a draft. */
export type DraftFacts = {
  /** Its file. */
  style: Style,
  /** The file with unusable blocks bypassed. */
  shown: Style,
  /** Whether all blocks are usable. */
  whole: boolean, background: LayerFacts, foreground: LayerFacts,
};

/** Analysis of a layer of a draft. */
export type LayerFacts = {
  /** For each of its blocks. */
  misfits: ReadonlyArray<Misfit | null>,
  /** For each block that could be added at the end, by id. */
  brings: Record<string, Misfit | null>,
};

/** Missing input of a block. */
export type Misfit = { lacks: Lack,
  /** The block that provides it. */
  remedy: string,
};

/** Missing input of a block. */
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

/** An edit. In JSON, an object with the name of the edit as `type`, and its fields. */
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
  /** The replaced photo. */
  id: string,
  /** The new photo. */
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
  /** `None` removes the focus point. */
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
  /** `None` restores the detected mask. */
  mask: string | null,
  /** The detected mask, for the panel breakouts of the photo. */
  found?: string,
}
| { "type": "describe-shots",
  /** The complete metadata of each shot, by photo id. */
  shots: Record<string, Shot>,
}
| { "type": "set-board",
  /** The complete settings of the storyboard. */
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
  /** Id of the page in the page history. */
  pageId: number,
}
| { "type": "change-page",
  /** The new page. */
  page: PageDocument,
}
| { "type": "change-settings",
  /** The settings. */
  settings: PageSettings,
  /** The page, or `None` without a page. */
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
   * Each has its page index as `sheet` and its `panel`, or its `photo`. `joins` continues the text
   * item before.
   */
  words: ReadonlyArray<Word & { sheet?: number; joins?: boolean }>,
}
| { "type": "set-words",
  /** For each page its index in the storyboard, and all its text items. */
  pages: ReadonlyArray<{ at: number; words: ReadonlyArray<Word> }>,
}
| { "type": "drop-waiting",
  /** Their numbers. */
  words: ReadonlyArray<number>,
}
| { "type": "no-page" }
| { "type": "design",
  /** `None` for an empty designer. */
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
  /** The project name. */
  name: string,
}
| { "type": "styling",
  /** Its settings. */
  styling: Styling,
}
| { "type": "undo" }
| { "type": "redo" }
| { "type": "share",
  /** The lists that changed. */
  lists: Partial<SharedLists>,
}
| { "type": "join",
  /** The lists to merge. */
  lists: Partial<SharedLists>,
} | Intent;

/**
 * An intent. In JSON, an object with its name as `type`, and its fields. Panels are indices into the panels
 * of the current page. An intent that is impossible, such as a change of a locked panel, changes nothing.
 */
export type Intent = { "type": "crop-panel",
  /** The panel. */
  panel: number,
  /** The change. */
  crop: CropChange,
}
| { "type": "swap-panels",
  /** A panel. */
  panel: number,
  /** The other panel. */
  with: number,
}
| { "type": "place-photo",
  /** The panel. */
  panel: number,
  /** Id of the photo, which must be in use. */
  photo: string,
}
| { "type": "lock-panel",
  /** The panel. */
  panel: number,
  /** Whether it is locked. */
  on: boolean,
}
| { "type": "break-frame",
  /** The panel. */
  panel: number,
  /** Mask of the subject; `None` removes the breakout. */
  mask: string | null,
}
| { "type": "merge-panels",
  /** The panels. All panels of a group that contains one of them are included. */
  panels: ReadonlyArray<number>,
}
| { "type": "split-panels",
  /** Panels of the groups; empty for all groups. */
  panels: ReadonlyArray<number>,
}
| { "type": "reshape",
  /** The change. To join panels, all panels of a group that contains one of them are included. */
  change: LayoutChange,
}
| { "type": "enlarge-panel",
  /** The panel. */
  panel: number,
}
| { "type": "recrop",
  /** The page, by its place in the storyboard. Default: the current page. */
  sheet?: number | null,
}
| { "type": "recrop-photo",
  /** Id of the photo. */
  photo: string,
  /** Whether the photo itself changed. Locked panels and other pages then get new crops too. */
  everywhere: boolean,
}
| { "type": "shuffle",
  /** The part of the page. */
  part: Shuffled,
  /** Random choices. */
  draw: Draw,
}
| { "type": "fit-layout",
  /** Random choices. */
  draw: Draw,
}
| { "type": "choose-layout",
  /** The layout. */
  layout: LayoutChoice,
  /** Seed of random choices. */
  seed: number,
}
| { "type": "choose-style",
  /** The style. */
  style: StyleChoice,
  /** Seed of random choices. */
  seed: number,
}
| { "type": "restyle",
  /** The style. */
  style: StyleChoice,
}
| { "type": "sort-photos" }
| { "type": "use-duplicate",
  /** Id of the photo. */
  photo: string,
  /** Ids of its near-duplicates. */
  alike: ReadonlyArray<string>,
}
| { "type": "refit",
  /** Whether there are more photos than before. */
  grow: boolean,
  /** Random choices. */
  draw: Draw,
}
| { "type": "set-paper",
  /** All settings. */
  settings: PageSettings,
  /**
   * Whether the user still drags a control. Only the current page then changes, because planning all
   * pages of an album at each step would delay the drag.
   */
  held: boolean,
  /** Learned preferences. */
  taste?: Taste,
}
| { "type": "compose",
  /** Ids of the photos, in order. */
  photos: ReadonlyArray<string>,
  /** Number of panels. */
  panels: number,
  /** The layout. Default: chosen automatically. */
  layout?: LayoutChoice | null,
  /** The style. Default: chosen automatically. */
  style?: StyleChoice | null,
  /** Randomness of the choice, as in a request for a page. */
  surprise?: number | null,
  /** Random choices. */
  draw: Draw,
}
| { "type": "add-page",
  /** Random choices. */
  draw: Draw,
}
| { "type": "remove-page" }
| { "type": "move-page",
  /** Its index in the storyboard. */
  from: number,
  /** Its index after the move. */
  to: number,
}
| { "type": "go-to-page",
  /** Its index in the storyboard. */
  at: number,
}
| { "type": "spread-album",
  /** Random choices. */
  draw: Draw,
}
| { "type": "style-pages" }
| { "type": "repair-pages",
  /** Groups of near-duplicates by photo id. */
  groups: Record<string, number>,
  /** Learned preferences. */
  taste?: Taste,
}
| { "type": "restore-version",
  /** Id of the page. */
  pageId: number,
  /** Learned preferences. */
  taste?: Taste,
};

/** Why the user cannot combine some panels of a page. */
export type Obstacles = {
  /** Why they cannot share one image. Null if they can. */
  merge: Obstacle | null,
  /** Why they cannot become one panel. Null if they can. */
  join: Obstacle | null,
};

/** Why panels cannot share one photo, or become one panel. */
export type Obstacle = "few" | "overlay" | "already" | "apart" | "uneven";

/** A change of the crop of a panel. `from` is the crop that it starts from; default: the current crop. */
export type CropChange = { "type": "pan",
  /** The crop at the start of the drag. */
  from?: Crop | null,
  /** Distance to the right, in widths of the image on the page. */
  x: number,
  /** Distance down, in heights of the image on the page. */
  y: number,
}
| { "type": "zoom",
  /** The crop at the start of the gesture. */
  from?: Crop | null,
  /** Values above 1 zoom in. */
  factor: number,
  /** The fixed point, in fractions of the image on the page. Default: the centre. */
  at?: [number, number] | null,
}
| { "type": "fit" }
| { "type": "reset" };

/** Part of a page that a shuffle changes. */
export type Shuffled = "all" | "layout" | "style" | "photos";

/** The basis of random choices. */
export type Draw = {
  /** The seed. */
  seed: number,
  /** Learned preferences. */
  taste?: Taste,
  /** How a style is chosen. */
  styling?: StylingRequest,
};

/** A part of the page. */
export type Part = "layout" | "style" | "photos";

/** How an edit is recorded in the history. In JSON, fields next to the fields of the edit. */
export type How = {
  /** Amends the present state without an undo step, for example while a page is still being completed. */
  silent?: boolean,
  /**
   * Name of a coalesced edit, such as one drag of a slider. A step with the name of the step before joins
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
  /** Photos in reading order, possibly more than panels. */
  order: ReadonlyArray<string>,
  /** Content of each panel, in paint order. */
  panels: ReadonlyArray<PanelUse>,
  /** Groups of panels that share one image. */
  merges: ReadonlyArray<ReadonlyArray<number>>,
  /** Size, gutters and colours. */
  page: PageSettings,
  /** The photos get one white point. Pages that were saved before this field have the colours of each photo. */
  balanced?: boolean,
  /** Text items on the page, in paint order. */
  words: ReadonlyArray<Word>,
};

/** Content of a panel. */
export type PanelUse = {
  /** Id of the photo; `None` for an empty panel. */
  photo: string | null,
  /** The part of the photo that fills the panel, or the group it is merged into. */
  crop: Crop | null,
  /** Faces of the photo, in fractions of it, which the style protects. Old pages have no faces here, and look unchanged. */
  faces?: ReadonlyArray<Crop>,
  /** Subject mask of the photo for a panel breakout. `None` disables the breakout. */
  figure?: string,
  /** Whether the panel is a logo: no style, no border, and described as a logo. */
  plain?: boolean,
  /** Whether a gray photo gets a warm tone, because other photos of the page have colours. */
  toned?: boolean,
  /** Whether every shuffle preserves the panel. */
  locked?: boolean,
  /** Whether the crop is manual. It stays as long as the photo stays in this panel. */
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
  /** Whether text has the larger size for screens. */
  forScreens?: boolean,
  /** Whether the page is read from right to left: its layout is mirrored. */
  rtl?: boolean,
  /** Whether photos are shown whole: the layout follows their aspect ratios. */
  wholePhotos?: boolean,
  /** Bleed in page widths, 0 to 0.1. For print files only; it is never saved. */
  bleed?: number,
  /**
   * Upscale photos below `COARSE` pixels per inch with edge enhancement. For printed files only; it is
   * never saved.
   */
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
 * A caption, a balloon or a sound effect. Omitted fields have defaults. Positions are fractions of the
 * bounds of its panel, or of the page without a panel.
 */
export type Word = {
  /** Kind. */
  kind: "caption" | "balloon" | "effect",
  /** Text; `\n` ends a line. */
  text: string,
  /** The outline of a balloon. Default: oval. */
  shape?: "oval" | "thought" | "shout" | "whisper" | "radio",
  /** Its panel. Default: positions are fractions of the page. */
  panel?: number | null,
  /** Its middle from the left. Default: 0.5. */
  x?: number,
  /** Its middle from the top. Default: 0.5. */
  y?: number,
  /** Width of the box or balloon in page widths. Default: fits the text. */
  width?: number | null,
  /** Height of an em in page widths. Default: as large as fits, between two limits. */
  size?: number | 'auto' | null,
  /** End of the tail of a balloon. */
  tail?: Focus | null,
  /** Id of a font. */
  font?: string,
  /** Text colour, and outline colour of a balloon, `#rrggbb`. Default: follows the style. */
  color?: string,
  /** Fill colour of a balloon or a box; outline colour of an effect, `#rrggbb`. Default: follows the style. */
  fill?: string,
  /** Degrees that an effect is turned clockwise. */
  angle?: number,
  /** Arc of a sound effect: 1 bends up by a third of a circle, -1 bends down by the same angle. */
  arc?: number,
  /** Whether the item is placed automatically, away from faces. Default: true without a position. */
  auto?: boolean,
  /** Whether a shuffle made it. The next shuffle replaces it. */
  made?: boolean,
  /** Whether it belongs to a book. A shuffle keeps it, another book replaces it. */
  book?: boolean,
  /** Whether it is a page number, which follows the position of the page. */
  number?: boolean,
  /** Whether it names a place by the location in a photo. */
  located?: boolean,
  /** The photo that it belongs to. The item follows this photo. Default: the photo on its panel. */
  photo?: string | null,
  /** The subtitle of origin, so that it is not added twice. */
  cue?: string | null,
  /** Whether a caption has no box. Its text is on the image, with an outline. */
  boxless?: boolean,
  /** Whether the caption is only left-aligned text from the top of its area. */
  plain?: boolean,
  /** Whether ruled lines replace the text of a caption. */
  ruled?: boolean,
  /** Whether it is set in capitals. Default: true by the rules of letterers, except effects. */
  capitals?: boolean | null,
  /** Slant of a sound effect in degrees to the right, -45 to 45. */
  slant?: number,
  /** Half the width of the outline of a sound effect, in ems, 0 to 0.4. */
  outline?: number | null,
  /** Whether an effect is behind the subject of its panel, if the subject is known. */
  behind?: boolean,
  /** Id, for links of other balloons. */
  id?: string | null,
  /** The id of the balloon that this one is linked to; both have one speaker. */
  joined?: string | null,
  /** Automatically linked balloon. It is found again at each automatic placement. */
  linked?: string | null,
  /** Whether this balloon is never linked automatically. */
  apart?: boolean,
  /** Name of the speaker, if known. Balloons of different speakers are never linked automatically. */
  by?: string,
  /** Language of the text, such as `en` or `pt-BR`, for hyphenation. Default: no hyphenation. */
  language?: string | null,
  /** Its lines are columns, read from the top down and from right to left. */
  vertical?: boolean,
  /** Width and height in page widths for an item without a set width, found during placement. */
  room?: readonly [width: number, height: number] | null,
};

/** Bounds of a text item without its tail, in page widths. */
export type WordBox = {
  /** Left edge. */
  x: number,
  /** Top edge. */
  y: number,
  /** Width. */
  width: number,
  /** Height. */
  height: number,
  /** End of the tail. */
  tip: Point | null,
  /** Height of an em. */
  size: number,
  /** Whether the end of the text was cut off. */
  cut: boolean,
  /** Text colour, `#rrggbb`. */
  color: string,
  /** Fill colour of its outline, or of the line around its glyphs. */
  fill: string,
  /** Id of its font. */
  font: string,
  /** Its place in the reading order of the page, from 0. */
  turn: number,
};

/** A page template that has passed every check of its schema (see `layouts/README.md`). */
export type Template = { id: string, name: string, family: string, aspect: number, order?: ReadonlyArray<number>, weights?: ReadonlyArray<number>,
} & ({ "tree": string | object }
| { "polygons": ReadonlyArray<ReadonlyArray<Point>> });

/** A style: a background layer and an optional foreground layer of lines. */
export type Style = {
  /** Name for programs. */
  id: string,
  /** Name for people. */
  name: string,
  /** Families it belongs to; the first is the main one. */
  tags: ReadonlyArray<string>,
  /** The colour layer. An empty layer leaves the photo unchanged. */
  background: ReadonlyArray<StyleStep>,
  /** The line layer; its luma is the alpha of the background over the ink. */
  foreground?: ReadonlyArray<StyleStep>,
  /** The parts of the picture that the layers are for. */
  where?: LayerParts,
  /** Colour of the lines. */
  ink?: string,
  /** Whether faces are protected. Default: true. */
  faces?: boolean,
  /** Whether pages in this style have dark paper. Default: false. */
  dark?: boolean,
  /** Score from 0 to 1 of a generated style. */
  score?: number,
};

/** One block of a layer with its values. */
export type StyleStep = { block: string; bypass?: boolean; where?: StylePart } & Record<string, ParamValue>;

/** A request for a page. The result depends on nothing else. */
export type Request = {
  /** Seed of all random choices. */
  seed: number,
  /** Photos in use, in order of time. */
  photos?: ReadonlyArray<PhotoMeta>,
  /** Size, gutters and colours of the page. */
  page?: PageSettings,
  /** The current page; `None` before the first page. */
  current?: PageDocument | null,
  /** Parts of the current page to retain. */
  keep?: Keep,
  /** The layout, by id or in full. Default: chosen automatically. */
  layout?: LayoutChoice | null,
  /** The style, by id or in full. Default: chosen automatically. */
  style?: StyleChoice | null,
  /** Options of the random choice of a style. */
  styling?: StylingRequest,
  /** Wanted number of panels if no layout is set. */
  panels?: number | null,
  /** How new photos are chosen. */
  mode?: Mode,
  /** Maximum fingerprint distance of near-duplicates, in bits of 64. A page avoids two photos that are this close. Default: 10. */
  duplicateThreshold?: number | null,
  /**
   * Whether the photos stay in their order along the page. Default: whether all are dated, at different times, or all are
   * frames of videos.
   */
  ordered?: boolean | null,
  /**
   * The photos of pages that were shown before, by id: the photo of the largest panel first, the last page last. Photos
   * that they do not show have their turn.
   */
  recent?: ReadonlyArray<ReadonlyArray<string>>,
  /**
   * Whether panels of a new layout share images: `true` always, `false` never. By default the choice is
   * random. If the request sets a layout or a number of panels, each panel has a separate image by
   * default.
   */
  merge?: boolean | null,
  /** Exactly these groups of panels share one image each. */
  merges?: ReadonlyArray<ReadonlyArray<number>> | null,
  /**
   * Whether a subject breaks its panel border, if the photos have masks and one of them fits: `true`
   * always, `false` never. By default the choice is random.
   */
  figures?: boolean | null,
  /** The user's learned preferences. */
  taste?: Taste,
  /** Families to choose from. */
  within?: Families,
  /** Recent results to avoid, besides the current page. */
  avoid?: Avoid,
  /** Randomness of the choice. Default: 1. Larger values give more surprising pages, and 0 takes the best candidate. */
  surprise?: number | null,
};

/** Retained parts of the current page. */
export type Keep = {
  /** The layout. */
  layout?: boolean,
  /** The style. */
  style?: boolean,
  /** The photos and their order. */
  photos?: boolean,
};

/** How new photos are chosen. */
export type Mode = "shuffle" | "photos";

/** Options of a book. */
export type BookWish = {
  /** The title. Default: the places or the days of the photos. */
  title?: string,
  /** Language of the text, such as `en` or `pt-BR`. */
  language?: string,
  /** The places of photos by id. */
  places?: { [key in string]: string },
  /** Dates in the format of the user. Default: in the format of the language. */
  dates?: BookDates,
  /** Number of pages with cover and end page, from `MIN_PAGES`. Default: as many as the photos need. */
  pages?: number,
  /** How styles are chosen. */
  styles?: BookStyles,
};

/** How the styles of a book are chosen. */
export type BookStyles = "one" | "chapters";

/** Dates in the format of the user. The texts of the language replace missing ones. */
export type BookDates = {
  /** The days of the book, for its cover. */
  span?: string,
  /** Dates for captions, by day such as `2026-06-09`. */
  days?: { [key in string]: string },
};

/**
 * The user's learned preferences, as natural logarithms of the factors for the weights of families and
 * styles. As JSON: `{families: {ID: NUMBER}, styles: {ID: NUMBER}}`. Both fields are optional, and values
 * that are not numbers are ignored.
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
 * Families for a random choice: of layouts, from `FAMILIES`(crate::layout::FAMILIES), and of styles, from
 * `FAMILIES`(crate::style::catalogue::FAMILIES). An empty list allows all. An explicit layout or style may
 * be in any family.
 */
export type Families = {
  /** Families of layouts. */
  layouts?: ReadonlyArray<string>,
  /** Families of styles. */
  styles?: ReadonlyArray<string>,
};

/**
 * Options of the random choice of a style. As JSON
 * `{extra, invented, inventions, keepLines, keepColours, quick}`; all fields are optional.
 */
export type StylingRequest = {
  /** Complete custom and favourite styles. They are chosen like built-in ones. */
  extra?: ReadonlyArray<Style>,
  /** Probability of a generated style, 0 to 1. */
  invented?: number,
  /** Generated styles that passed a test. If the list is present, even if it is empty, only its styles are used. */
  inventions?: ReadonlyArray<Style>,
  /** Retain the line layer and its ink. */
  keepLines?: boolean,
  /** Retain the colour layer. */
  keepColours?: boolean,
  /** Leave out styles with the block Painter, because a page in such a style takes seconds. */
  quick?: boolean,
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
  /** Energy map of the photo. */
  energy: EnergyMap,
  /** Capture time, `YYYY:MM:DD HH:MM:SS`, if the file contains it. */
  taken: string | null,
  /** Lettering, and the faces and objects found in it once detection has run. */
  subjects: ReadonlyArray<Subject>,
  /** The focus point that the user set. */
  focus: Focus | null,
  /** Tones, texture and colour. `None` if the photo was never measured, as in old projects. */
  facts?: string,
  /** Subject mask, after detection. */
  mask?: string,
  /** Whether the user starred it: it gets a large panel. */
  starred?: boolean,
  /** Whether it is a frame of a video. */
  frame?: boolean,
  /** Whether the photo is missing, and its measurements belong to a placeholder. */
  absent?: boolean,
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
  /** Points of a face. `None` for objects, and for faces of old projects. */
  points?: ReadonlyArray<[number, number]>,
  /** Eyes and mouth of a face. `None` for objects and small faces, and without the landmark model. */
  expression?: Expression,
  /**
   * Light of a face, compared with its photo: 0 in the shade of a bright photo, 1 in light. `None` for objects, and for faces
   * of old projects.
   */
  light?: number,
};

/** Eyes and mouth of a face, as ratios of distances in the face. */
export type Expression = {
  /** Distance of the lids of the person's right eye, in widths of the eye: about 0.2 if shut, and 0.3 if open. */
  rightEye: number,
  /** The left eye. */
  leftEye: number,
  /** Distance of the lips, in widths of the mouth: 0 if closed. In a video frame with a subtitle, the change of the distance. */
  mouth: number,
  /** Height of the corners of the mouth above its middle, in widths of the mouth. It is negative in a sad face. */
  smile: number,
};

/** A filter block, as data for its controls. */
export type Block = {
  /** Name in style files. */
  id: string,
  /** Display name: the technical term. */
  label: string,
  /** Plain name, if the label is a technical term. */
  plain?: string,
  /** Description in one line. */
  help: string,
  /** Channels of the input. */
  input: Channels,
  /** Channels of the output. */
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
  /** Description in one line. */
  help: string,
  /** Type and range. */
  kind: ParamKind,
  /** Default value in style files. */
  default: ParamValue,
  /** Smallest value of a number. */
  min?: number,
  /** Its largest value. */
  max?: number,
  /** Step of its slider. */
  step?: number,
  /** Unit symbol. */
  unit?: string,
  /** The names to choose from. */
  choices?: ReadonlyArray<string>,
};

/** Type of a parameter. */
export type ParamKind = "number" | "integer" | "boolean" | "choice" | "texture" | "model" | "colour";

/** Input and output channels of a block. */
export type Channels = "luma" | "color" | "any";

/** A part of a picture. */
export type StylePart = "subject" | "background";

/** The parts that the layers of a style apply to; the whole picture if a layer defines no part. */
export type LayerParts = {
  /** The part of the colour layer: the photo is unchanged outside it. */
  background?: StylePart,
  /** The part of the line layer: no lines are drawn outside it. */
  foreground?: StylePart,
};

/** An entry in the list of layouts, in unit coordinates. */
export type Layout = {
  /** Unique name in kebab-case. */
  id: string,
  /** Display name. */
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
  /** Visual prominence of the panel. */
  weight: number,
  /** Whether the panel is an overlay. */
  overlay: boolean,
};

/** The outline of a panel: a polygon or a circle. */
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
  /** Display name. */
  name: string,
  /** Its family. */
  family: string,
  /** Panels. */
  count: number,
  /** Index among the custom layouts; null for a built-in layout. */
  own: number | null,
  /** Its panels as an SVG path on a page 1000 wide. */
  base: string,
  /** Its overlays likewise. */
  over: string,
};

/** Possible changes of a layout on a page. */
export type LayoutFacts = {
  /** Unique name in kebab-case. */
  id: string,
  /** Display name. */
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
  /** Position in its cell, 0 to 1. */
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

/** A manual change of a layout. */
export type LayoutChange = { "type": "move-cut",
  /** Its place among the cuts. */
  cut: number,
  /** Position in its cell, 0 to 1. */
  fraction: number,
  /** As in the file. */
  slant: number,
}
| { "type": "split",
  /** Which. */
  panel: number,
  /** Direction of the division. */
  axis: Axis,
}
| { "type": "remove",
  /** Which. */
  panel: number,
}
| { "type": "join",
  /** Which. */
  panels: ReadonlyArray<number>,
}
| { "type": "move-inset",
  /** Which. */
  panel: number,
  /** Its new bounds on the page of the request, in page widths. */
  bounds: Bounds,
};

/** Request of the list of layouts. */
export type LayoutsRequest = {
  /** The page that they are for. */
  page: PageSettings,
  /** Whether it is a custom layout. */
  own?: ReadonlyArray<Template>,
};

/** Requirements of a generated layout. */
export type GenerateRequest = {
  /** Random seed. */
  seed: number,
  /** The page that it is for. */
  page: PageSettings,
  /** Panels at least, */
  least: number,
  /** and at most. */
  most: number,
};

/** Panels on a page of width 1, with gutters and margins. */
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

/** A panel on the page, in page widths. Its outline is a polygon or a circle. */
export type PlacedPanel = {
  /** Corners; the first is joined to the last. */
  polygon?: ReadonlyArray<Point>,
  /** A circle. */
  circle?: Circle,
  /** The rectangle round the outline. */
  bounds: Bounds,
  /** Whether the panel is an overlay. */
  overlay: boolean,
  /** Width of the paper-coloured outline around the panel. 0 without an outline. */
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

/** The selection's verdict on a photo. */
export type Verdict = {
  /** Id of the photo. */
  id: string,
  /** Number of its group of look-alikes. */
  group: number,
  /** Whether it is used. */
  kept: boolean,
  /** The reason in a few English words. */
  why: string,
  /** The reason. */
  reason: VerdictReason,
};

/** Why a photo is used or left out. Displays as a few English words. */
export type VerdictReason = { "code": "only" }
| { "code": "sharpest",
  /** Number of photos in the group, at least 2. */
  of: number,
}
| { "code": "open-eyes",
  /** Number of photos in the group, at least 2. */
  of: number,
}
| { "code": "same-as",
  /** Name of the photo that is used. */
  name: string,
}
| { "code": "blurred" }
| { "code": "frame" };

/** Request of a selection. */
export type ChoiceRequest = {
  /** All photos. */
  photos: ReadonlyArray<Candidate>,
  /** Maximum fingerprint distance of near-duplicates, in bits of 64. */
  duplicateThreshold?: number,
};

/** A photo that may be worth a panel. */
export type Candidate = {
  /** Its id. */
  id: string,
  /** Display name. */
  name: string,
  /** See `MeasuresEntry`. */
  fingerprint: string,
  /** See `MeasuresEntry`. */
  gradient: number,
  /** See `MeasuresEntry`. */
  paper: number,
  /** See `MeasuresEntry`. */
  laplacian: number,
  /** The video that it is a frame of. */
  film?: string | null,
  /** The faces whose eyes are known. */
  faces?: ReadonlyArray<Expression>,
};

/** Measurements for the selection, as JSON. */
export type Measures = {
  /** The 64-bit fingerprint in 16 hexadecimal digits. */
  fingerprint: string,
  /** Sharpness, comparable between photos that show the same. */
  gradient: number,
  /** Sharpness by the measure of Garcia-Dorado et al., see `select::sharpness::paper`. */
  paper: number,
  /** Sharpness, comparable across an album. */
  laplacian: number,
};

/** Data of an imported photo for the app. */
export type ImportEntry = {
  /** Measurements for framing. */
  meta: PhotoMeta,
  /** Name of the file's format. */
  format: string,
  /** The damage of the file, if any. */
  damage: Damage | null,
  /** Measurements for the selection. */
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
  /** Missing share of the image, drawn grey, from 0 to 1. */
  missing: number,
  /** Share of the image without detail, from 0 to 1. */
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
  /** Points of a face. `None` for objects. */
  points?: ReadonlyArray<[number, number]>,
  /** Eyes and mouth of a face. `None` for objects and small faces, and without the landmark model. */
  expression?: Expression,
  /** Light of a face, compared with its photo: 0 in the shade of a bright photo, 1 in light. `None` for objects. */
  light?: number,
};

/** Result of the first search for faces. */
export type FirstLook = {
  /** The faces. */
  boxes: ReadonlyArray<Detection>,
  /** Whether a second pass over parts of the photo may find more, even without objects. */
  closer: boolean,
};

/** A sound of a video. */
export type SoundEvent = {
  /** Seconds at which it begins */
  start: number,
  /** and ends. */
  end: number,
  /** Kind of the sound. */
  kind: SoundKind,
  /** Level in whole dB below full scale, -42 to about 0: of the loudest frame, or the mean for music. */
  loudness: number,
  /** Suggested sound effects, the best first. */
  words: [SoundWord, SoundWord, SoundWord],
};

/** Kind of a sound. */
export type SoundKind = "hit" | "sweep" | "music";

/** Names of sound effects. Each language has its own spelling. */
export type SoundWord = "bang" | "boom" | "clang" | "clap" | "click" | "clink" | "crack" | "crash" | "ding" | "knock" | "note" | "notes" | "rumble" | "slam" | "snap" | "swish" | "tap" | "thud" | "thump" | "tick" | "tune" | "vroom" | "whoosh" | "zip" | "zoom";

/** Request to combine two styles. */
export type BreedRequest = { a: StyleChoice, b: StyleChoice, seed: number,
  /** 0 to 1. */
  surprise: number,
};

/** The tables that states name their parts of. */
export type Tables = { items: ReadonlyArray<TrayItem>, trays: ReadonlyArray<ReadonlyArray<number>>, pages: ReadonlyArray<PageDocument>, sheets: ReadonlyArray<KeptSheet>, books: ReadonlyArray<ReadonlyArray<number>>, styles: ReadonlyArray<Style>, shelves: ReadonlyArray<ReadonlyArray<number>>, layouts: ReadonlyArray<Template>, layoutShelves: ReadonlyArray<ReadonlyArray<number>>, settings: ReadonlyArray<PageSettings>, drafts: ReadonlyArray<Draft>, words: ReadonlyArray<Word>, waits: ReadonlyArray<ReadonlyArray<number>>, boards: ReadonlyArray<Board>,
};

/** The difference after a change, see `difference` in `crates/model/src/kept.rs`. */
export type Difference = {
  /** The fields that changed. */
  present: Partial<KeptState>, shown: Runs, entries: ReadonlyArray<KeptShown>,
  /** The edits that an intent led to. */
  edits: ReadonlyArray<KeptEdit>, parts: Tables, undos: number, redos: number,
  /** Whether the steps to undo are others. */
  stepped: boolean,
  /** Whether the history changed at all. */
  changed: boolean,
  /** Number of earlier changes that a journal need not have. */
  includes: number,
  /** Dropped parts, as sentences. */
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
  /** Dropped parts, as sentences. */
  dropped: ReadonlyArray<string>,
};

/** A project file or the text of a page, checked. */
export type ReadProject = { format: string, version: number, history: { present: Project; shown: ReadonlyArray<Shown> }, photos: ReadonlyArray<FilePhoto>, videos: ReadonlyArray<FileVideo>,
  /** Dropped parts, as sentences. */
  dropped: ReadonlyArray<string>,
};

/** Metadata of a photo in a file. */
export type FilePhoto = {
  /** Its id in the document. */
  id: string,
  /** The name of its file. */
  name: string,
  /** Its place in the archive. */
  path: string,
  /** Media type of the file, empty if unknown. */
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
  /** Detected subjects; `None` before detection. */
  subjects: ReadonlyArray<Subject> | null,
  /** Subject mask. */
  mask?: string,
  /** Its place in time among the photos. */
  rank: number | null,
  /** Identity, to find the photo without its file. */
  like: Likeness | null,
  /** Whether an empty frame replaces the photo. */
  absent: boolean,
};

/** Metadata of a video in a file. */
export type FileVideo = {
  /** Names it. */
  key: string,
  /** The name of its file. */
  name: string,
  /** Its place in the archive. */
  path: string,
  /** The type of its file. */
  type: string,
  /** Ids of photos that are frames of the video. */
  ids: ReadonlyArray<string>,
  /** Duration in seconds; `None` until the file was opened. */
  duration: number | null,
  /** Frames are taken from here, */
  start: number,
  /** to here. */
  end: number | null,
  /** Timecode of the first frame. */
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

/** Options of a PDF file. Default: one sheet per page, in colour, without marks. */
export type PdfOptions = {
  /** Title of the file. */
  title?: string,
  /** Language of the text, as a tag such as `pt-BR`. Empty: not specified. */
  language?: string,
  /** Crop marks and fold marks. */
  marks?: boolean,
  /** How pages share sheets. */
  imposition?: Imposition | null,
  /**
   * Width and height in millimetres of the sheets, in either orientation. The content is scaled to fit.
   * `None`: sheets fit the content.
   */
  paper?: [number, number] | null,
  /** Index in `inks` of the ink of this plate. `None`: all colours. */
  plate?: number | null,
  /** The colours on white paper of the inks of plates, the strongest last. */
  inks?: ReadonlyArray<[number, number, number]>,
};

/** How pages share sheets. */
export type Imposition = "booklet" | "zine" | "2up" | "spreads";

/** Pages that become one file. */
export type Comic = {
  /** Title. */
  title: string,
  /**
   * BCP 47 tag, such as `en`. The reader's interface uses this language, or English if it is not
   * available.
   */
  language: string,
  /** File format of the images. */
  picture: PictureKind,
  /** Its pages in order. */
  pages: ReadonlyArray<ComicPage>,
};

/** A page of a comic. */
export type ComicPage = {
  /** The page. Its image has the page's size. */
  document: PageDocument,
  /** Content of each panel, such as `two people and a dog`, in paint order. Empty if unknown. */
  shows: ReadonlyArray<string>,
  /** Areas of animated panels, in fractions of the page, in paint order. Only HTML comics show them. */
  moving?: ReadonlyArray<Crop>,
};

/** An image format. */
export type PictureKind = "png" | "jpeg" | "webp";

/**
 * A part of a file: text, or the image of the page with this index. The animated panels follow after the
 * images of all pages, page by page.
 */
export type Piece = string | number;

/** A file of an archive. */
export type ComicFile = {
  /** Its name, with the folders that it is in. */
  name: string,
  /** Content. */
  content: Piece,
};

/** A request of the app for a strip. */
export type StripRequest = {
  /** The pages in order. */
  pages: ReadonlyArray<PageDocument>,
  /** The photos of the pages by id. */
  photos: { [key in string]: StripPhoto },
};

/** A photo of a strip. */
export type StripPhoto = {
  /** Capture time, `YYYY:MM:DD HH:MM:SS`. */
  taken: string | null,
  /** Faces and objects, which text avoids. */
  subjects: ReadonlyArray<Subject>,
};

/** A value of a parameter: a number, an entry of its choices, or whether it is on. */
export type ParamValue = number | string | boolean;

/** The lists that all projects have in common. They are a part of each project, so that undo reaches them. */
export type SharedLists = Pick<Project, 'mine' | 'favourites' | 'ownLayouts'>;

/** Consecutive numbers. */
export type Runs = ReadonlyArray<readonly [first: number, count: number]>;

/** Fields of a state that are stored in tables and referenced by number. */
export type Tabled = 'tray' | 'settings' | 'page' | 'others' | 'draft' | 'board' | 'waiting' | 'mine' | 'favourites' | 'ownLayouts';

/** A state whose parts are stored in tables. */
export type KeptState = Omit<Project, Tabled> & {
  [Field in Exclude<Tabled, 'board' | 'waiting'>]: number | Extract<Project[Field], null>;
} & { board?: number | null; waiting?: number };

/** A page of a storyboard, and a version of a page. Their pages are stored in a table. */
export type KeptSheet = Omit<Sheet, 'page'> & { page: number };
export type KeptShown = Omit<Shown, 'page'> & { page: number };

/** An edit that an intent led to. Its pages and settings are stored in tables. */
export type KeptEdit = How & (
| { type: 'show-page'; page: number; pageId: number }
| { type: 'change-page'; page: number }
| { type: 'change-settings'; settings: number; page?: number }
| { type: 'set-sheets'; sheets: ReadonlyArray<KeptSheet>; at: number }
| { type: 'no-page' }
);

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
| 'damaged-painters'
| 'large-painters'
| 'slow-painters'
| 'invalid-painters'
| 'encode';
