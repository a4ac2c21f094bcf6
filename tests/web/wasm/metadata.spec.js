// @ts-check
/** Removing metadata changes no pixel: each photo is decoded before and after, by the core or by the browser. */

import { readFile, readdir } from 'node:fs/promises';
import { soiled } from '../../../www/engine/metadata/testing.ts';
import { expect, test } from '../../../www/testing.ts';
import { openCore } from './core.js';

/** The object that `openCore` stored in the page. @type {any} */
let core;

const DATA = new URL('../../oracles/data/', import.meta.url);
/** Photos, by folder. */
const FOLDERS = { files: /./, foreign: /\.avif$/, animations: /./ };

for (const [folder, kinds] of Object.entries(FOLDERS)) {
  test(`photos of ${folder} look the same when what was put in beside their pixels is out`, async ({ page }) => {
    await openCore(page);
    const names = (await readdir(new URL(`${folder}/`, DATA))).filter(
      (name) => /\.(jpg|png|webp|gif|bmp|tif|avif)$/.test(name) && kinds.test(name),
    );
    expect(names.length).toBeGreaterThan(1);
    for (const name of names) {
      const file = await readFile(new URL(`${folder}/${name}`, DATA));
      const [plain, loud] = [file, soiled(file)].map((bytes) => Buffer.from(bytes).toString('base64'));
      const { before, after, again, clean, told } = await page.evaluate(lookedAt, { plain, loud });
      expect.soft(before.pixels, name).toMatch(/^\d+ x \d+: \w{64}$/);
      expect.soft(after, name).toEqual(before);
      expect.soft(again, name).toEqual(before);
      expect.soft([clean, told], name).toEqual([true, false]);
    }
  });
}

/**
 * Runs in the page.
 * @param {{ plain: string, loud: string }} files the same photo in base64, as it was and with words in it
 */
async function lookedAt({ plain, loud }) {
  const [{ withoutMetadata }, { reading }] = await Promise.all([
    import(/** @type {any} */ ('/engine/metadata/strip.ts')),
    import(/** @type {any} */ ('/engine/readable.ts')),
  ]);
  /** @param {Uint8Array<ArrayBuffer>} bytes */
  const seen = async (bytes) => {
    const studio = new core.Studio();
    const read = (/** @type {Uint8Array} */ file) => studio.import_photo('a', file);
    const { meta, work } = JSON.parse((await reading(bytes, read)).value);
    const { width, height } = meta;
    const digest = await crypto.subtle.digest('SHA-256', studio.photo_planes('a/work'));
    const hash = [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
    studio.free();
    return { pixels: `${width} x ${height}: ${hash}`, work: [work.width, work.height] };
  };
  const bytesOf = (/** @type {string} */ text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stripped = async (/** @type {Uint8Array<ArrayBuffer>} */ bytes) => {
    const { blob, clean } = await withoutMetadata(new Blob([bytes]));
    return { bytes: new Uint8Array(await blob.arrayBuffer()), clean };
  };
  const [once, twice] = [await stripped(bytesOf(loud)), await stripped(bytesOf(plain))];
  const told = new TextDecoder('latin1').decode(once.bytes).includes('SECR');
  return {
    before: await seen(bytesOf(plain)),
    after: await seen(once.bytes),
    again: await seen(twice.bytes),
    clean: once.clean,
    told,
  };
}
