import { deflateRawSync } from 'node:zlib';
import { describe, expect, it, test, vi } from 'vitest';
import { createShelves } from '../storage/shelves.ts';
import { createOwnStyles } from './own-styles.ts';
import { isStyleLink, linkOf, textOfLink } from './style-link.ts';
import { fakeApp } from '../document/testing.ts';

vi.mock('../ui/files.ts', () => ({ save: vi.fn() }));

const MINE = 'inkpanel.styles';
const style = (id: string, more = {}) => ({ id, name: id.toUpperCase(), tags: [], background: [], ...more });

/** @param full whether the storage is full */
function app(kept: Record<string, string> = {}, full: boolean = false) {
  const made = fakeApp();
  const planner = made.planner as any;
  planner.styles = () => [style('noir')];
  planner.checkStyle = (json: string, file: string) => {
    const read = JSON.parse(json);
    if (!Array.isArray(read.background)) throw new Error(`style ${file}: background: is missing`);
    return read;
  };
  const box = {
    getItem: (key: string) => kept[key] ?? null,
    setItem: (key: string, value: string) => {
      if (full) throw new Error('quota');
      kept[key] = value;
    },
  };
  const opened: any[] = [];
  let ids = 0;
  const designer = { open: (what: any) => void opened.push(what), change: () => {} };
  const styles = createOwnStyles({ ...made, designer, freshId: () => `fresh-${(ids += 1)}` });
  createShelves({ ...made, box: () => box }).recall();
  return { ...made, styles, opened, kept: (key = MINE) => JSON.parse(kept[key] ?? '[]') };
}

const file = (name: string, what: any) => new File([typeof what === 'string' ? what : JSON.stringify(what)], name);

describe('my styles', () => {
  it('are kept, replaced by their id, deleted, and brought back by undo', () => {
    const { styles, kept, pages } = app();
    styles.save(style('a'));
    styles.save(style('b'));
    styles.save(style('a', { name: 'New' }));
    expect(kept().map(({ name }: any) => name)).toEqual(['New', 'B']);
    styles.remove('a');
    expect(kept()).toHaveLength(1);
    pages.undo();
    expect(kept().map(({ id }: any) => id)).toEqual(['a', 'b']);
  });

  it('are there again the next time; what can no longer be read is not', () => {
    const { styles } = app({ [MINE]: JSON.stringify([style('a'), { id: 'broken' }]) });
    expect(styles.mine.value.map(({ id }) => id)).toEqual(['a']);
    expect(app({ [MINE]: 'no json' }).styles.mine.value).toEqual([]);
  });

  it('tell when the storage takes no more, and last as long as the page', () => {
    const { styles, messages } = app({}, true);
    styles.save(style('a'));
    expect(styles.mine.value).toHaveLength(1);
    expect(messages.list.value.some(({ kind, text }) => kind === 'grave' && text.includes('full or blocked'))).toBe(
      true,
    );
  });

  it('come from files, each wrong one with its reason', async () => {
    const { styles, messages, kept, reading, files, opened } = app();
    await reading.addFiles(files('a', 'b'));
    await styles.open([
      file('bad.json', {}),
      file('noir.json', style('noir', { name: 'Other' })),
      file('long.json', ' '.repeat(600_000)),
    ]);
    await vi.waitFor(() => expect(messages.list.value.map(({ text }) => text)).toContain('2 files could not be read.'));
    const alerts = messages.failures.value.map(({ text }) => text);
    expect(alerts[0]).toMatch(/bad\.json.*background.*missing/);
    expect(alerts[1]).toMatch(/long\.json.*512 KB/);
    // Another style with the id of a built-in style gets a new id.
    expect(kept()).toEqual([style('fresh-1', { name: 'Other' })]);
    expect(opened.map(({ id }) => id)).toEqual(['fresh-1']);
  });

  it('are marked as favourites, and no longer', () => {
    const { styles, kept } = app();
    styles.favour(style('x'));
    expect([styles.isFavourite('x'), kept('inkpanel.favourites').length]).toEqual([true, 1]);
    styles.favour(style('x'));
    expect([styles.isFavourite('x'), kept('inkpanel.favourites').length]).toEqual([false, 0]);
  });
});

test('a style travels as a link', async () => {
  const sent = style('a', { background: [{ block: 'xdog', sigma: 1.2 }], name: 'Grüße' });
  const link = await linkOf(sent);
  expect(link).toMatch(/^#style=[\w-]+$/);
  expect([isStyleLink(link), isStyleLink('#other')]).toEqual([true, false]);
  expect(JSON.parse(await textOfLink(link))).toEqual(sent);
  const { styles, opened, reading, files } = app();
  await reading.addFiles(files('a'));
  await styles.openLink(link);
  expect(opened).toEqual([sent]);
});

describe('a link that holds no style', () => {
  const packed = (what: string | Buffer) => `#style=${deflateRawSync(what).toString('base64url')}`;
  const good = deflateRawSync(JSON.stringify(style('a'))).toString('base64url');
  const cases: [string, string, RegExp][] = [
    ['nothing', '#style=', /empty/],
    ['odd letters', '#style=a!b', /letters that no link has/],
    ['spaces', `#style=${good} `, /letters/],
    ['one letter', '#style=A', /part of it is missing/],
    ['no deflate', `#style=${Buffer.from('hello there').toString('base64url')}`, /missing or was changed/],
    ['cut short', `#style=${good.slice(0, 20)}`, /missing or was changed/],
    ['a huge link', `#style=${'A'.repeat(17_000)}`, /too long/],
    ['a small link of a huge text', packed(' '.repeat(2 ** 22)), /the style in it is too long/],
    ['bytes that are no text', packed(Buffer.from([0xff, 0xfe, 0x80])), /missing or was changed/],
  ];
  it.each(cases)('%s', async (_, link, reason) => {
    const { styles, messages } = app();
    await styles.openLink(link);
    expect(messages.list.value.map(({ text }) => text)).toEqual([expect.stringMatching(reason)]);
  });

  it.each([
    ['no JSON', 'nope'],
    ['another thing', '[1]'],
    ['no layers', '{"id":"a"}'],
  ])('%s', async (_, text) => {
    const { styles, messages, kept } = app();
    await styles.openLink(packed(text));
    expect(messages.list.value).toHaveLength(1);
    expect(kept()).toEqual([]);
  });
});
