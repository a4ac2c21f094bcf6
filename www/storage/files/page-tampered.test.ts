import { beforeEach, describe, expect, it, vi } from 'vitest';
import { chunkOf, textChunk, withChunks } from '../../engine/png-chunks.ts';
import { withProject } from './page-file.ts';
import { fakeBrowser } from '../testing.ts';
import { alerts, bare, bytesOf, downloaded, dropped, inPanels, textIn, tripTab } from './testing-pages.ts';
import type { Tab } from './testing-pages.ts';

let tab: Tab;

beforeEach(async () => {
  tab = await tripTab();
});

describe('a page that was tampered with', () => {
  async function changed(change: (json: any, page: any) => unknown): Promise<File> {
    const json = JSON.parse(await textIn(await downloaded(tab, 'project')));
    const made = change(json, json.history.present.page) ?? json;
    return new File(
      [await withProject(await bare(), typeof made === 'string' ? made : JSON.stringify(made), [])],
      'x.png',
    );
  }

  it.each([
    ['no JSON', () => changed(() => '{"format"'), /damaged/],
    ['nothing', () => changed(() => ''), /damaged/],
    [
      'another format',
      () =>
        changed((json) => {
          json.format = 'other';
        }),
      /damaged/,
    ],
    [
      'no version',
      () =>
        changed((json) => {
          delete json.version;
        }),
      /damaged/,
    ],
    [
      'a newer page',
      () =>
        changed((_, page) => {
          page.version = 2;
        }),
      /newer version of Inkpanel/,
    ],
    [
      'no page',
      () =>
        changed((json) => {
          json.history.present.page = null;
        }),
      /damaged/,
    ],
    [
      'an unknown layout',
      () =>
        changed((_, page) => {
          page.layout = 'gone';
        }),
      /damaged/,
    ],
    [
      'too many panels',
      () =>
        changed((_, page) => {
          page.panels = Array(100_000).fill(page.panels[0]);
        }),
      /exceeds the limits of a project/,
    ],
    [
      'a crop beyond the photo',
      () =>
        changed((_, page) => {
          page.panels[1].crop = { x: 0.9, y: 0, width: 0.5, height: 1 };
        }),
      /damaged/,
    ],
    [
      'a crop of words',
      () =>
        changed((_, page) => {
          page.panels[1].crop = { x: 'a', y: 0, width: 1, height: 1 };
        }),
      /damaged/,
    ],
    [
      'panels merged twice',
      () =>
        changed((_, page) => {
          page.merges = [
            [0, 1],
            [1, 2],
          ];
        }),
      /damaged/,
    ],
    [
      'a merge of a panel that is not there',
      () =>
        changed((_, page) => {
          page.merges = [[0, 7]];
        }),
      /damaged/,
    ],
    [
      'photos that are no list',
      () =>
        changed((json) => {
          json.photos = { length: 1e9 };
        }),
      /damaged/,
    ],
    [
      'a photo of a billion pixels a side',
      () =>
        changed((json) => {
          json.photos[0].like.width = 1e9;
        }),
      null,
    ],
    [
      'a photo that is like nothing',
      () =>
        changed((json) => {
          json.photos[0].like = { hash: 7 };
        }),
      null,
    ],
    [
      'thousands of photos',
      () =>
        changed((json) => {
          const photos = Array.from({ length: 4_000 }, (_, i) => ({
            ...json.photos[0],
            id: `n${i}`,
            path: `photos/n${i}`,
          }));
          json.photos.push(...photos);
        }),
      null,
    ],
    [
      'a text that unpacks to gigabytes',
      async () =>
        new File(
          [await withChunks(await bare(), { before: [await textChunk('inkpanel', ' '.repeat(64 << 20))] })],
          'x.png',
        ),
      /damaged/,
    ],
    [
      'a text that is cut',
      async () =>
        new File(
          [
            await withChunks(await bare(), {
              before: [await chunkOf('iTXt', new Blob(['inkpanel\0', Uint8Array.of(1, 0, 0, 0, 120, 156, 3)]))],
            }),
          ],
          'x.png',
        ),
      /damaged/,
    ],
  ])('by %s changes nothing on the page, or opens', async (_, make, reason) => {
    const file = await make();
    const before = JSON.stringify(tab.store.project.value);
    const { opened } = await dropped(tab, file);
    expect(opened).toBe(reason === null);
    if (reason === null) expect(inPanels(tab)).toHaveLength(3);
    else
      expect([JSON.stringify(tab.store.project.value), alerts(tab).map(({ text, way }) => [text, way?.label])]).toEqual(
        [before, [[expect.stringMatching(reason), 'Use as a photo']]],
      );
    expect(tab.keeping.files.progress.value).toBe(null);
  });

  it('by a byte of its photos lacks these, and says so', async () => {
    const file = await downloaded(tab, 'photos');
    const bytes = await bytesOf(file);
    bytes[Buffer.from(bytes).lastIndexOf('photo-2b.jpg') + 'photo-2'.length] ^= 1;
    const other = await fakeBrowser().tab();
    await dropped(other, new File([bytes], 'page.png'));
    expect(inPanels(other)).toEqual(['photo-1', 'Missing photo 1', 'photo-3']);
    const said = () =>
      alerts(other)
        .map(({ text }) => text)
        .join();
    expect(said()).toMatch(/1 of its 3 photos is not on this device/);
    await vi.waitFor(() => expect(said()).toMatch(/photo-2.*damaged/));
  });
});
