/**
 * The wasm module: instantiated on the main thread for planning and in each worker for pixels.
 */

import initCore, * as core from '../pkg/inkpanel.js';
import type { Program } from './protocol.ts';
import type {
  Block,
  BoardPicture,
  BookWish,
  BreedRequest,
  ChoiceRequest,
  Difference,
  Draw,
  Draft,
  DraftEdit,
  DraftFacts,
  GenerateRequest,
  Geometry,
  Layout,
  LayoutChoice,
  LayoutEntry,
  LayoutFacts,
  Obstacles,
  PageDocument,
  PageSettings,
  PhotoMeta,
  ReadProject,
  Request,
  Sheet,
  Style,
  Template,
  Verdict,
} from './types.ts';

/** A request to the planner, always with photos, page and locked parts. */
export type PlanRequest = Request &
  Pick<Required<Request>, 'photos' | 'page' | 'current'> & { keep: Required<NonNullable<Request['keep']>> };

/** Photos no longer planned with that are remembered, since undo may bring them back. */
const SPARE_PHOTOS = 500;

/** Starts the core. @returns its functions for planning */
export async function startCore(program: Program) {
  await initCore({ module_or_path: program });
  return createPlanner();
}

export type Planner = ReturnType<typeof createPlanner>;
export type Editor = ReturnType<typeof createEditor>;
/**
 * Options for planning a page. Omitted fields use the project's settings. `photos`: photos to use (default: photos that
 * are free for the page). `anew`: ignore the existing page.
 */
export type Wish = Partial<Omit<PlanRequest, 'current'>> &
  Pick<PlanRequest, 'keep'> & { current?: PageDocument; anew?: boolean };
/** Reason why no page has shown a photo yet: it is not its turn, it is a page of text, or it has too few pixels. */
export type Unseen = 'waits' | 'text' | 'small';

/**
 * The pure functions of the core, with plain objects in place of JSON. Each call takes at most a few milliseconds and
 * throws an error with a `code`.
 */
export function createPlanner() {
  const album = createAlbum();
  return {
    blocks: (): Block[] => JSON.parse(core.blocks()),
    layouts: (): Layout[] => JSON.parse(core.layouts()),
    styles: (): Style[] => JSON.parse(core.styles()),
    /**
     * @param json the text of a style file
     * @param file its name, for the message
     */
    checkStyle: (json: string, file: string): Style => JSON.parse(core.check_style(json, file)),
    /**
     * @param json the text of a layout file
     * @param file its name, for the message
     */
    checkLayout: (json: string, file: string): Template => JSON.parse(core.check_layout(json, file)),
    /** @returns the number of painters in a model. Throws if it is not one */
    paintersIn: (onnx: Uint8Array): number => core.painters_in(onnx),
    geometry: (layout: LayoutChoice, page: PageSettings): Geometry =>
      JSON.parse(core.page_geometry(JSON.stringify({ layout, page }))),
    /**
     * @param request `own`: custom layouts
     * @returns those first, then the catalogue's that are good for the page
     */
    listLayouts: (request: { page: Partial<PageSettings>; own: readonly Template[] }): LayoutEntry[] =>
      JSON.parse(core.list_layouts(JSON.stringify(request))),
    layoutFacts: (layout: LayoutChoice, page: PageSettings): LayoutFacts =>
      JSON.parse(core.layout_facts(JSON.stringify({ layout, page }))),
    /** @returns in full */
    layoutFile: (layout: LayoutChoice): Template => JSON.parse(core.layout_file(JSON.stringify({ layout }))),
    /** @param request the numbers of panels */
    generateLayout: (request: GenerateRequest): Template => JSON.parse(core.generate_layout(JSON.stringify(request))),
    plan: ({ photos, ...rest }: PlanRequest): PageDocument =>
      JSON.parse(album.of(photos).plan(JSON.stringify(rest), idsOf(photos))),
    /** Crops of photos for an aspect ratio, in the order of their ids. */
    frames: (photos: readonly PhotoMeta[], ids: readonly string[], aspect: number): BoardPicture[] =>
      JSON.parse(album.of(photos).frames(JSON.stringify(ids), aspect)),
    /** @returns invented */
    inventStyle: (seed: number): Style => JSON.parse(core.invent_style(seed)),
    /**
     * @param request `surprise`: 0 to 1
     * @returns a child of both
     */
    breedStyle: (request: BreedRequest): Style => JSON.parse(core.breed_style(JSON.stringify(request))),
    /** @returns a draft that has no block */
    emptyDraft: (id: string, name: string): Draft => JSON.parse(core.empty_draft(id, name)),
    draftOf: (style: Style): Draft => JSON.parse(core.draft_of(JSON.stringify(style))),
    /** @returns null if nothing changes or the edit is impossible */
    editDraft: (draft: Draft, edit: DraftEdit): Draft | null =>
      JSON.parse(core.edit_draft(JSON.stringify(draft), JSON.stringify(edit))),
    draftFacts: (draft: Draft): DraftFacts => JSON.parse(core.draft_facts(JSON.stringify(draft))),
    choose: (photos: ChoiceRequest['photos'], duplicateThreshold: number): Verdict[] =>
      JSON.parse(core.choose_photos(JSON.stringify({ photos, duplicateThreshold }))),
    /**
     * Reads a project file or the text of a page PNG and checks all of it. Throws `damaged-project`, `newer-project` or `too-large-project`.
     * @param how `prefix`: all photos and videos get fresh ids that begin with it
     * @returns `dropped`: sentences about what was left out
     */
    readProject: (text: string, { prefix }: { prefix?: string } = {}): ReadProject =>
      JSON.parse(core.read_project(text, prefix)),
    createEditor: () => createEditor(album),
    /** @returns applies the changes between two states of a list to another state */
    carried: <T>(list: readonly T[], before: readonly T[], after: readonly T[]): T[] =>
      JSON.parse(core.carried(JSON.stringify({ list, before, after }))),
  };
}

/** The editor of a project with its history. The app has a readable copy of the present and of the page history. */
function createEditor(album: KnownPhotos) {
  const editor = new core.Editor();
  return {
    /**
     * Replaces the history by one that is not validated, and checks all of it. Throws `damaged-project`,
     * `newer-project` or `too-large-project`, or `invalid-document` for the journal, and then nothing changed.
     * @param bytes as from `save`
     * @param journal changes that were made since, as JSON: a list of lists of edits
     * @returns the difference to an empty project
     */
    load: (bytes: Uint8Array, journal = ''): Difference => JSON.parse(editor.load(bytes, journal)),
    /**
     * Throws `invalid-document`, and for intents the errors of the planner. Then nothing changed.
     * @param edit as JSON
     * @param photos in use, for intents; omitted if they are the same as before
     */
    apply: (edit: string, photos?: readonly PhotoMeta[]): Difference =>
      JSON.parse(editor.apply(album.using(photos), edit)),
    /** @returns the page that an intent would make the current page; null if the page stays */
    preview: (edit: string, photos: readonly PhotoMeta[]): PageDocument | null =>
      JSON.parse(editor.preview(album.using(photos), edit)),
    /** @returns why panels of the current page cannot be merged or joined; null if nothing prevents it */
    obstacles: (panels: readonly number[]): Obstacles => JSON.parse(editor.obstacles(JSON.stringify(panels))),
    /** @returns the history with tables: JSON in UTF-8 */
    save: (): Uint8Array<ArrayBuffer> => editor.save() as Uint8Array<ArrayBuffer>,
    /** @returns the ids of all photos of the history */
    photos: (): string[] => JSON.parse(editor.photos()),
    plans: (photos: readonly PhotoMeta[]) => plansOf(editor, album.using(photos)),
  };
}

/** Planned pages of a project, for use in edits; null if a plan is impossible. */
function plansOf(editor: core.Editor, album: core.Album) {
  return {
    page: ({ photos, anew = false, ...wish }: Wish & Pick<PlanRequest, 'seed'>): PageDocument | null =>
      JSON.parse(editor.plan(album, JSON.stringify(wish), photos ? idsOf(photos) : '', anew)),
    /**
     * Begins a book of the photos in use. `step` plans a page and returns whether there are more; `sheets` returns the pages, and
     * ends it, as `stop` does.
     * @returns null without a page
     */
    book: (draw: Draw, wish: BookWish) => {
      const maker = editor.book(album, JSON.stringify(draw), JSON.stringify(wish));
      return (
        maker && {
          length: maker.length,
          step: () => maker.step(),
          sheets: (): Sheet[] => JSON.parse(editor.booked(album, maker)),
          stop: () => maker.free(),
        }
      );
    },
    /** Whether one of the other pages shows a photo that is not in use. */
    torn: () => editor.torn(album),
    /** @returns the photos in use that no page has shown yet, and why */
    unseen: (): { photo: string; why: Unseen }[] => JSON.parse(editor.unseen(album)),
    /** @returns the ids of unused photos, as text */
    freePhotos: () => editor.free_photos(album),
  };
}

function idsOf(photos: readonly PhotoMeta[]): string {
  return JSON.stringify(photos.map(({ id }) => id));
}

type KnownPhotos = ReturnType<typeof createAlbum>;

/** The core's album. Each photo is passed once, and again when its measurements change. */
function createAlbum() {
  const album = new core.Album();
  const told: Map<string, PhotoMeta> = new Map();
  let used: readonly PhotoMeta[] | null = null;
  return { of, using };

  /** @returns an album with these photos */
  function of(photos: readonly PhotoMeta[]): core.Album {
    const fresh = photos.filter((photo) => told.get(photo.id) !== photo);
    if (fresh.length > 0) album.know(JSON.stringify(fresh));
    for (const photo of fresh) told.set(photo.id, photo);
    if (told.size > 2 * photos.length + SPARE_PHOTOS) {
      const ids = new Set(photos.map(({ id }) => id));
      album.keep(JSON.stringify([...ids]));
      for (const id of [...told.keys()]) if (!ids.has(id)) told.delete(id);
      used = null;
    }
    return album;
  }

  /**
   * @param photos another list where another is in use; omitted if they are the same as before
   * @returns an album with these photos in use
   */
  function using(photos?: readonly PhotoMeta[]): core.Album {
    if (!photos || photos === used) return album;
    of(photos).take(idsOf(photos));
    used = photos;
    return album;
  }
}
