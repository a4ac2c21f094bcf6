/**
 * Tests every importer of user files with files that are damaged in many ways. Each file is imported, or a message
 * gives the reason. Vitest fails on unhandled errors.
 */

import fc from 'fast-check';
import { readFileSync, readdirSync } from 'node:fs';
import { afterAll, describe, expect, test, vi } from 'vitest';
import { importShots } from '../boards/board-import.ts';
import { createBoards } from '../boards/boards.ts';
import { logoOf } from '../boards/logo-file.ts';
import { textureOf } from '../designer/texture-file.ts';
import { fakeApp } from '../document/testing.ts';
import { failure } from '../engine/protocol.ts';
import { zipOf } from '../engine/testing-archives.ts';
import { readAssetsFromFiles } from '../engine/testing-assets.ts';
import { core } from '../engine/testing-core.ts';
import { smallModel } from '../engine/testing-painters.ts';
import { createImitation } from '../imitation/imitation.ts';
import { createOwnLayouts } from '../layouts/own-layouts.ts';
import { momentsOf } from '../lettering/cue-times.ts';
import { createFilmSounds } from '../lettering/film-sounds.ts';
import { createSubtitling } from '../lettering/subtitling.ts';
import { soundOf } from '../motion/sound.ts';
import { downloaded } from '../storage/files/testing-pages.ts';
import { allDie, fakeBrowser } from '../storage/testing.ts';
import { createOwnPainters } from '../painters/own-painters.ts';
import { createOwnStyles } from '../styles/own-styles.ts';
import { linkOf } from '../styles/style-link.ts';
import { save as saveFile } from '../ui/files.ts';
import { importing } from '../ui/importing.ts';
import { createMessages } from '../ui/messages.ts';
import { createDroppedFiles } from './dropped-files.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

const SEED = 40;
readAssetsFromFiles();

/** Number of files per format. Slow formats get fewer files. */
const MANY = { numRuns: 150, seed: SEED };
const FEW = { numRuns: 30, seed: SEED };

type Bytes = Uint8Array<ArrayBuffer>;
const bytesOf = (text: string) => new TextEncoder().encode(text) as Bytes;

/** Texts that are hard on parsers. */
const ODD = [
  '',
  '\ufeff',
  '\0',
  '\ud800',
  '\u2028\u2029\u0085',
  'İı\u0307ﬁ\u202e👩‍👩‍👧',
  'constructor',
  '__proto__',
  '"',
  '\r',
  '\n\n  \n',
  '[['.repeat(2_000),
  '{"a":'.repeat(2_000),
  'x'.repeat(200_000),
  `${' '.repeat(100_000)}x`,
  ','.repeat(20_000),
];

/** Damages of a file: truncated, other bytes, additional or repeated parts, another encoding, or empty. */
function damaged(files: readonly Bytes[]): fc.Arbitrary<Bytes> {
  const file = fc.constantFrom(...files);
  const place = fc.double({ min: 0, max: 1, noNaN: true });
  const at = (bytes: Bytes, part: number) => Math.floor(part * bytes.length);
  const joined = (...parts: Uint8Array[]) => new Uint8Array(Buffer.concat(parts));
  const piece = fc.oneof(
    fc.uint8Array({ maxLength: 64 }),
    fc.constantFrom(...ODD).map(bytesOf),
    fc.string().map(bytesOf),
  );
  return fc.oneof(
    file,
    fc.tuple(file, place).map(([bytes, end]) => bytes.slice(0, at(bytes, end))),
    fc.tuple(file, place).map(([bytes, start]) => bytes.slice(at(bytes, start))),
    fc.tuple(file, fc.array(fc.tuple(place, fc.nat(255)), { minLength: 1, maxLength: 8 })).map(([bytes, flips]) => {
      const other = bytes.slice();
      for (const [part, byte] of flips) other[at(bytes, part)] = byte;
      return other;
    }),
    fc
      .tuple(file, place, piece)
      .map(([bytes, part, more]) => joined(bytes.subarray(0, at(bytes, part)), more, bytes.subarray(at(bytes, part)))),
    fc
      .tuple(file, place, place)
      .map(([bytes, from, to]) => joined(bytes, bytes.subarray(at(bytes, from), at(bytes, to)))),
    file.map((bytes) => new Uint8Array(Buffer.from(`\ufeff${new TextDecoder().decode(bytes)}`, 'utf16le'))),
    fc
      .array(fc.oneof(fc.constantFrom(...ODD), fc.string()), { maxLength: 6 })
      .map((parts) => bytesOf(parts.join('\n'))),
    fc.uint8Array({ maxLength: 300 }).map((bytes) => new Uint8Array(bytes)),
  );
}

/** Messages that are counted. */
function counted() {
  const messages = createMessages();
  let said = 0;
  for (const kind of ['alert', 'note', 'offer', 'grave', 'fileFailed'] as const) {
    const say = messages[kind] as (...args: unknown[]) => unknown;
    (messages as any)[kind] = (...args: unknown[]) => {
      said += 1;
      expect(args.filter((arg) => typeof arg === 'string').every((text) => text !== '')).toBe(true);
      return say(...args);
    };
  }
  return { messages, said: () => said };
}

/**
 * Imports damaged files.
 * @param take imports a file, and returns whether that changed anything, or undefined if that is unknown
 */
async function survives(
  {
    files,
    names,
    runs,
  }: { files: readonly Bytes[]; names: readonly string[]; runs: { numRuns: number; seed: number } },
  { said }: { said: () => number },
  take: (file: File) => Promise<unknown>,
) {
  await fc.assert(
    fc.asyncProperty(damaged(files), fc.constantFrom(...names), async (bytes, name) => {
      const before = said();
      const changed = await take(new File([bytes], name));
      expect(changed === true || said() > before, `${name} was not imported, and nothing was said`).toBe(true);
    }),
    runs,
  );
}

const read = (folder: string, count: number) =>
  readdirSync(new URL(folder, import.meta.url))
    .filter((name) => name.endsWith('.json'))
    .slice(0, count)
    .map((name) => new Uint8Array(readFileSync(new URL(folder + name, import.meta.url))));

afterAll(allDie);

describe('files for the shots of a board', () => {
  const TABLES = [
    'Scene,Shot,Picture,Film,Time code,Duration,Frames,Action,Dialogue,Notes,Lens\r\n1,101,a.jpg,,,00:00:02:00,48,"She ""waits"",\nthen goes.",,\'=1+1,35\r\n',
    'sep=;\r\nSzene;Einstellung;Dauer;Handlung\r\n1;1A;2:12;Öffnet die Tür\r\n;;;\r\n2;1B;36f;Geht\r\n',
    'Picture\tAction\na.jpg\tA\na.jpg\tB\nc.jpg\tC\n',
  ].map(bytesOf);
  const SCRIPTS = [
    'Title: Night\nAuthor: Ann\n\n# Act\n\nINT. HALL - NIGHT #4#\n\n= Ann comes.\n\nShe _opens_ the *door* [[slowly]].\n\nANNA (V.O.) ^\n(quiet)\n~La la\nHello?\n\n/* cut */\n\n> CUT TO:\n\n> THE END <\n',
    'SINGER\n~These are the songs\n~That I sing.\n',
  ].map(bytesOf);

  async function board() {
    const { messages, said } = counted();
    const app = fakeApp();
    await app.reading.addFiles(app.files('a.jpg', 'a.jpg', 'c.jpg'));
    const boards = createBoards({ store: app.store, engine: app.engine, chooseStyle: () => {} });
    return { said, take: (file: File) => importShots(file, { boards, store: app.store, messages }) };
  }

  test('tables', async () => {
    const { said, take } = await board();
    await survives({ files: TABLES, names: ['a.csv', 'a.tsv', 'a.txt'], runs: MANY }, { said }, take);
  });

  test('screenplays', async () => {
    const { said, take } = await board();
    await survives({ files: SCRIPTS, names: ['a.fountain', 'a.spmd', 'a.txt'], runs: MANY }, { said }, take);
  });
});

describe('speech', () => {
  const SPEECH = [
    '1\r\n00:00:01,000 --> 00:00:02,500\r\n<i>Hello</i> {\\an8}there\r\n\r\n2\r\n00:01:00,5 --> 01:00:01,250\r\n- Bye\r\n- No\r\n',
    'WEBVTT Kind: captions\n\nNOTE a remark\n\nintro\n00:04.000 --> 00:05.000 align:start\n<v Anna>Tom &amp; Jerry</v>\n',
    'PAGE 1, PANEL 1\nCaption: Lisbon.\nAnna (whispers): Where\nare we?\n\nSFX: Bam\n',
  ].map(bytesOf);

  test('subtitles, scripts and the times in them', async () => {
    const { messages, said } = counted();
    const app = fakeApp();
    await app.reading.addFiles(app.files('a.jpg', 'b.jpg'));
    const lettering = {
      lay: (words: readonly unknown[]) => ({ shown: words.length, waiting: 0 }),
      ready: async () => ({}),
    };
    const { open } = createSubtitling({ store: app.store, lettering: lettering as any, messages });
    const film = new File(['x'], 'a.mp4', { type: 'video/mp4' });
    await survives(
      { files: SPEECH, names: ['a.srt', 'a.vtt', 'a.ass', 'a.sbv', 'a.txt'], runs: MANY },
      { said },
      async (file) => {
        for (const moments of (await momentsOf([film], [file])).values())
          expect(moments.every(Number.isFinite)).toBe(true);
        await open([file]);
      },
    );
  });
});

describe('layouts and styles', () => {
  test('layouts', async () => {
    const { messages, said } = counted();
    const { store, pages } = fakeApp();
    const { open } = createOwnLayouts({ store, pages, messages });
    await survives({ files: read('../../layouts/', 3), names: ['a.json'], runs: MANY }, { said }, (file) =>
      open([file]),
    );
  });

  function styles() {
    const { messages, said } = counted();
    const { store, planner } = fakeApp();
    Object.assign(planner, { checkStyle: core.checkStyle });
    const designer = { open: () => {}, change: () => {} };
    let ids = 0;
    return { said, ...createOwnStyles({ store, messages, designer, freshId: () => `my-${(ids += 1)}` }) };
  }

  test('styles', async () => {
    const { said, open } = styles();
    await survives({ files: read('../../styles/', 3), names: ['a.json'], runs: MANY }, { said }, (file) =>
      open([file]),
    );
  });

  test('styles in links', async () => {
    const { said, openLink } = styles();
    const [style] = read('../../styles/', 1);
    const link = bytesOf(await linkOf(JSON.parse(new TextDecoder().decode(style))));
    await survives({ files: [link], names: ['a'], runs: MANY }, { said }, async (file) => {
      await openLink(`#style=${(await file.text()).slice('#style='.length)}`);
    });
  });
});

describe('pictures for styles and boards', () => {
  const PICTURES = [
    Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13),
    new Uint8Array(readFileSync(new URL('../../tests/photos/cat.jpg', import.meta.url))).slice(0, 4_000),
  ];

  test('textures', async () => {
    const { messages, said } = counted();
    const check = (style: object, name: string) => core.checkStyle(JSON.stringify(style), name);
    await survives({ files: PICTURES, names: ['a.png', 'a.jpg'], runs: MANY }, { said }, async (file) => {
      return (await importing(messages, file.name, () => textureOf(file, check as any))) !== undefined;
    });
  });

  test('models of painters', async () => {
    const { messages, said } = counted();
    const shelf = { all: async () => [], put: async () => {}, remove: async () => {} };
    const parts = { designer: { draft: { peek: () => null } }, ui: { work: { peek: () => null } }, shelf };
    const store = { planner: { peek: () => core }, page: { value: null } };
    const { open } = createOwnPainters({ ...parts, store, messages } as any);
    const files = [smallModel(), smallModel({ painters: 12, channels: 8 })];
    await survives({ files, names: ['a.onnx'], runs: MANY }, { said }, (file) => open([file]));
  });

  test('logos, which the browser decodes', async () => {
    const { messages, said } = counted();
    vi.stubGlobal(
      'Image',
      class {
        decode = () => Promise.reject(new DOMException('bad', 'EncodingError'));
      },
    );
    await survives({ files: PICTURES, names: ['a.png', 'a.svg'], runs: FEW }, { said }, async (file) => {
      await importing(messages, file.name, () => logoOf(file));
    });
    vi.unstubAllGlobals();
  });
});

/** Whatever decoders throw. */
const THROWN = [
  new Error('it is damaged.'),
  new TypeError('x is undefined'),
  new RangeError('Invalid array length'),
  new DOMException('gone', 'NotReadableError'),
  failure('unknown-format', 'No image.'),
  failure('film-codec', 'HEVC'),
  'text',
  null,
  undefined,
  {},
];

describe('files of which the decoder throws', () => {
  test('photos and films are named, each with a reason', async () => {
    for (const thrown of THROWN) {
      const app = fakeApp();
      app.engine.importPhoto = app.engine.importVideo = () => Promise.reject(thrown);
      vi.spyOn(app.messages, 'fileFailed');
      const films = [new File(['x'], 'b.mp4', { type: 'video/mp4' }), new File(['GIF89a'], 'c.gif')];
      await app.reading.addFiles([...app.files('a.jpg'), ...films]);
      const failed = vi.mocked(app.messages.fileFailed).mock.calls;
      expect(failed.map(([name]) => name).sort()).toEqual(['a.jpg', 'b.mp4', 'c.gif']);
      expect(failed.every(([, why]) => why.length > 5)).toBe(true);
    }
  });

  test('a picture for a style is answered with a sentence', async () => {
    for (const thrown of THROWN) {
      const engine = { importPhoto: () => Promise.reject(thrown), forgetPhoto: () => {} };
      const parts = { engine, store: fakeApp(), ui: { work: { value: null } }, messages: createMessages() };
      const app = fakeApp();
      await app.reading.addFiles(app.files('a.jpg'));
      const imitation = createImitation({ ...parts, store: app.store, seed: () => 1, freshId: () => 'x' } as any);
      imitation.take([new File(['x'], 'a.jpg')]);
      await imitation.search('p1');
      expect(imitation.fault.value?.length).toBeGreaterThan(5);
    }
  });

  test('the sound of a film is answered with a sentence, and a sound file is named', async () => {
    for (const thrown of THROWN) {
      const video = { key: 'v', name: 'a.mp4', file: new File(['x'], 'a.mp4'), ids: [], duration: 1, start: 0, end: 1 };
      const engine = { hearFilm: () => Promise.reject(thrown) };
      const { hear, of } = createFilmSounds({ store: fakeApp().store, engine, lettering: {}, messages: {} } as any);
      await hear(video);
      expect(of(video)).toEqual({ why: expect.stringMatching(/.{6}/) });
    }
    await expect(soundOf(new File(['x'], 'a.mp3'), 2)).rejects.toMatchObject({ code: 'sound-unread', photo: 'a.mp3' });
  });
});

describe('files that are dropped', () => {
  /** A browser with a project, and files with projects and pages. */
  async function dropping() {
    const tab = await fakeBrowser().tab();
    await tab.add('a.jpg');
    await tab.keeping.flush();
    vi.mocked(saveFile).mockClear();
    await tab.keeping.files.save();
    const [project] = vi.mocked(saveFile).mock.calls[0];
    const page = await downloaded(tab, 'photos');
    const { said, messages } = counted();
    Object.assign(tab.messages, {
      ...Object.fromEntries(
        (['alert', 'note', 'offer', 'grave', 'fileFailed'] as const).map((kind) => [kind, messages[kind]]),
      ),
    });
    const open = async (files: readonly File[]) => {
      for (const { name } of files) messages.note(name);
    };
    const { take, openProjects } = createDroppedFiles({
      ...(tab as any),
      subtitling: { open },
      ownLayouts: { open },
      ownStyles: { open },
      ownPainters: { open },
      showProjects: () => {},
    });
    const state = () => `${tab.keeping.current.peek()} ${tab.names().length}`;
    const changes = (way: (files: File[]) => Promise<void>) => async (file: File) => {
      const before = state();
      await way([file]);
      return state() !== before;
    };
    const bytes = async (blob: Blob) => new Uint8Array(await blob.arrayBuffer());
    return {
      said,
      take: changes(take),
      openProjects: changes(openProjects),
      project: await bytes(project),
      page: await bytes(page),
    };
  }

  test('projects', async () => {
    const { said, take, openProjects, project } = await dropping();
    await survives({ files: [project], names: ['a.inkpanel'], runs: FEW }, { said }, take);
    await survives({ files: [project], names: ['a.inkpanel', 'a.zip'], runs: FEW }, { said }, openProjects);
  });

  test('archives', async () => {
    const { said, take, project } = await dropping();
    const pictures = { '1/a.jpg': 'photo', 'b.png': 'bad', '__MACOSX/._b.png': '' };
    const archive = zipOf(
      Object.entries(pictures).map(([name, text]) => ({ name, content: Buffer.from(text), packed: true })),
    );
    await survives({ files: [new Uint8Array(archive), project], names: ['a.zip', 'a.cbz'], runs: FEW }, { said }, take);
  });

  test('pages with their project', async () => {
    const { said, take, openProjects, page } = await dropping();
    await survives({ files: [page], names: ['a.png'], runs: FEW }, { said }, take);
    await survives({ files: [page], names: ['a.png'], runs: FEW }, { said }, openProjects);
  });

  test('files of any name', async () => {
    const { said, take } = await dropping();
    const names = ['a.jpg', 'a.gif', 'a.webp', 'a.mp4', 'a.txt', 'a.srt', 'a.json', 'a', '.a', 'a.xmp', '☃.heic'];
    await survives({ files: read('../../layouts/', 1), names, runs: { ...FEW, numRuns: 60 } }, { said }, take);
  });
});
