/**
 * The pages as a board: their photos as shots in reading order, then the photos that no page shows; the edits that change them,
 * the sheets, and the lists as files. Shot metadata is stored on the photo in the document.
 */

import { computed } from '@preact/signals';
import type { Store } from '../document/store.ts';
import { MOST } from '../engine/bounds.ts';
import type { Engine } from '../engine/engine.ts';
import type { Board, ListedShot, PageDocument, Shot, ShotList } from '../engine/types.ts';
import { sizeId } from '../page/paper.ts';
import { strings } from '../strings/strings.ts';
import { createLogos } from './logos.ts';
import { shotsOf } from './page-shots.ts';
import { similarShots } from './similar-shots.ts';
import type { ShotRow } from './shots.ts';
import {
  ASPECTS,
  lengthOf,
  lengthText,
  NO_BOARD,
  numbered,
  ordered,
  SPOKEN,
  UNSPOKEN,
  USUAL_SECONDS,
  withColumn,
  withField,
} from './shots.ts';

export type Boards = ReturnType<typeof createBoards>;
/** A column of the list: a standard field, the length, or a custom field. */
export type Column = { kind: 'field' | 'length' | 'own'; id: string };

const UNTOLD = { scene: '', action: '', notes: '', more: {} };

/** The look of markers, and six frames of a screen on a sheet. */
const FILM_BOARD = { style: 'storyboard', frames: 6, aspect: '16:9', beside: false } as const;
const AMERICAN = /letter|legal|tabloid|^us-/;

/** Whether a page is a comic page, not a storyboard sheet. */
export function isComic({ layout }: PageDocument): boolean {
  return typeof layout === 'string' || layout.family !== 'board';
}

export function createBoards({
  store,
  engine,
  chooseStyle,
}: {
  store: Store;
  engine: Pick<Engine, 'boardSheets' | 'importPhoto' | 'forgetPhoto'>;
  chooseStyle: (style: string) => void;
}) {
  const logoOf = createLogos(engine);
  const board = computed(() => store.project.value.board ?? NO_BOARD);
  /** The shots of the pages. Sheets of a board are not pages of the comic. */
  const pageShots = computed(() => shotsOf(store.sheets.value.filter(isComic), store.planner.value));
  const rows = computed((): readonly ShotRow[] => {
    const items = new Map(store.tray.value.map((item) => [item.id, item]));
    const used = store.photos.value.map(({ id }) => id);
    const there = new Set(used);
    const onPages = [...pageShots.value.keys()].filter((id) => there.has(id));
    const ids = ordered(board.value.order, [...new Set([...onPages, ...used])]);
    return numbered(
      ids.map((id) => ({ id, shot: items.get(id)?.shot ?? {}, said: pageShots.value.get(id) ?? UNSPOKEN })),
    );
  });
  const columns = computed((): readonly Column[] => [
    ...(['scene', 'number'] as const).map((id) => ({ kind: 'field' as const, id })),
    { kind: 'length', id: 'length' },
    ...(['action', ...SPOKEN, 'notes'] as const).map((id) => ({ kind: 'field' as const, id })),
    ...board.value.columns.map((id) => ({ kind: 'own' as const, id })),
  ]);
  /** The shots that look like the shot before, by the ids of their photos. */
  const similar = computed(() => similarShots(rows.value, store.album.value));
  /** Frames of all shots together. */
  const total = computed(() => rows.value.reduce((sum, { shot }) => sum + framesOf(shot), 0));

  return {
    isComic,
    board,
    rows,
    columns,
    similar,
    total,
    textOf,
    put,
    describe,
    change,
    move,
    followPages,
    addColumn,
    shotList,
    sheets,
    filmBoard,
  };

  function framesOf(shot: Shot) {
    return shot.frames ?? USUAL_SECONDS * board.value.fps;
  }

  /** The text of a cell. */
  function textOf({ shot, said }: Pick<ShotRow, 'shot' | 'said'>, { kind, id }: Column): string {
    if (kind === 'own') return shot.more?.[id] ?? '';
    if (kind === 'length') return shot.frames === undefined ? '' : lengthText(shot.frames, board.value);
    return shot[id as 'action'] ?? said[id as 'dialogue'] ?? '';
  }

  /** @returns the shot with the new text of a cell; null for an invalid length */
  function withCell(shot: Shot, { kind, id }: Column, typed: string): Shot | null {
    const text = typed.trim().slice(0, id === 'scene' || id === 'number' ? MOST.label : MOST.field);
    if (kind === 'own') return withColumn(shot, id, text);
    if (kind === 'field') return withField(shot, id, text);
    const frames = lengthOf(text, board.peek(), MOST.shotFrames);
    if (frames === undefined) return null;
    const { frames: _, ...rest } = shot;
    return frames === null ? rest : { ...rest, frames };
  }

  /**
   * Puts texts into cells, from one on to the right and down, as one step.
   * @returns number of rejected cells: beyond the list, or with an invalid length
   */
  function put(from: { row: number; column: number }, texts: readonly (readonly string[])[]): number {
    const changed: Record<string, Shot> = {};
    let lost = 0;
    texts.forEach((line, down) => {
      const row = rows.peek()[from.row + down];
      line.forEach((text, across) => {
        const column = columns.peek()[from.column + across];
        const shot = row && column ? withCell(changed[row.id] ?? row.shot, column, text) : null;
        if (shot) changed[row.id] = shot;
        else if (text.trim() !== '') lost += 1;
      });
    });
    describe(changed);
    return lost;
  }

  /** @param shots by the ids of their photos */
  function describe(shots: Record<string, Shot>, gesture?: string) {
    if (Object.keys(shots).length > 0) store.change({ type: 'describe-shots', shots, ...(gesture && { gesture }) });
  }

  function change(part: Partial<Board>, gesture?: string) {
    store.change({ type: 'set-board', board: { ...board.peek(), ...part }, ...(gesture && { gesture }) });
  }

  /** Carries a shot to another place in the order. */
  function move(from: number, to: number) {
    const ids = rows.peek().map(({ id }) => id);
    if (from === to || to < 0 || to >= ids.length) return;
    const [id] = ids.splice(from, 1);
    ids.splice(to, 0, id);
    change({ order: ids });
  }

  /** Gives the shots the order of the pages again. */
  function followPages() {
    change({ order: [] });
  }

  /** @returns whether the column exists now */
  function addColumn(name: string): boolean {
    const plain = name.trim().slice(0, MOST.label);
    const own = board.peek().columns;
    if (plain === '' || own.includes(plain) || own.length >= MOST.columns) return false;
    change({ columns: [...own, plain] });
    return true;
  }

  /** The shots in the format of exported lists, with headings in the current language. */
  function shotList(): ShotList {
    const { fps, pace, columns: own } = board.peek();
    const album = store.album.peek();
    const videos = store.videos.peek();
    const shots = rows.peek().map(({ id, number, shot, said }): ListedShot => {
      const fact = album.get(id);
      const video = fact?.video === undefined ? undefined : videos.get(fact.video);
      const { number: _, ...told } = shot;
      const film = video && {
        key: video.key,
        name: video.name,
        time: fact?.time ?? 0,
        length: video.duration ?? undefined,
        timecode: video.timecode,
      };
      return { ...UNTOLD, ...said, ...told, number, name: fact?.name ?? id, ...(film && { film }) };
    });
    const { heading } = strings.boards;
    const title = store.project.peek().name;
    return { title, fps, ...(pace && { pace }), columns: [...own], headings: Object.values(heading), shots };
  }

  /** The sheets of the board as pages, in the style of the page. */
  async function sheets(): Promise<PageDocument[]> {
    const { frames, aspect, beside, ruled, author, date, logo } = board.peek();
    const ratio = ASPECTS[aspect] ?? 16 / 9;
    const { labels } = strings.boards;
    const page = store.page.peek();
    const pictures =
      store.planner.peek()?.frames(
        store.photos.peek(),
        rows.peek().map(({ id }) => id),
        ratio,
      ) ?? [];
    return engine.boardSheets({
      list: shotList(),
      pictures,
      frames,
      aspect: ratio,
      beside,
      ruled,
      author,
      date,
      ...(logo && { logo: await logoOf(logo) }),
      letter: page !== null && AMERICAN.test(sizeId(page.page)),
      style: page?.style ?? FILM_BOARD.style,
      labels: { ...labels, page: labels.page({ page: '{page}', count: '{count}' }) },
    });
  }

  /** The default storyboard for film production. */
  function filmBoard() {
    const { style, ...part } = FILM_BOARD;
    chooseStyle(style);
    change({ ...part, ruled: false });
  }
}
