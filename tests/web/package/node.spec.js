// @ts-check
/** The package in Node, without a browser: its pixels equal the pixels of the native program. */

import { execFileSync } from 'node:child_process';
import { copyFileSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PNG, expect, test } from '../../../www/testing.ts';
import { inkpanel, picture, stylizeNatively } from '../wasm/native.js';
import { emptyProject } from './project.js';

const PHOTOS = fileURLToPath(new URL('../../../www/public/samples/', import.meta.url));

/** @param {Uint8Array} one @param {Uint8Array} other @returns {number} the largest difference, 255 of unequal lengths */
function apart(one, other) {
  if (one.length !== other.length) return 255;
  return one.reduce((most, value, i) => Math.max(most, Math.abs(value - other[i])), 0);
}

test('Node draws pages, styles and saved projects as the native program does, within 1', ({}, info) => {
  const project = emptyProject();
  try {
    const at = (/** @type {string} */ name) => join(project.folder, name);
    const names = ['07-red-panda', '19-astronaut'];
    names.forEach((name, i) => copyFileSync(join(PHOTOS, `${name}.jpg`), at(['one.jpg', 'two.jpg'][i])));
    inkpanel(
      'render',
      '--pages',
      '2',
      '--page-size',
      '800x1000',
      '--seed',
      '3',
      '-o',
      at('album.inkpanel'),
      at('one.jpg'),
      at('two.jpg'),
    );
    inkpanel('render', at('album.inkpanel'), '-o', at('native-%02d.png'));
    const photo = picture();
    writeFileSync(at('pixels.rgba'), photo.data);
    writeFileSync(at('size.json'), JSON.stringify([photo.width, photo.height]));
    const comic = JSON.parse(readFileSync(new URL('../../../styles/comic.json', import.meta.url), 'utf8'));
    const native = stylizeNatively(photo, comic, (name) => info.outputPath(name));

    copyFileSync(new URL('node.js', import.meta.url), at('node.mjs'));
    const seen = JSON.parse(execFileSync(process.execPath, ['node.mjs'], { cwd: project.folder, encoding: 'utf8' }));
    expect(seen.chosen).toEqual([
      { group: 0, kept: true },
      { group: 1, kept: true },
    ]);
    expect(seen.labels).toContain('face');
    expect([seen.undone, seen.redone]).toEqual([true, true]);
    expect(seen.changed, 'pixels that words change').toBeGreaterThan(1000);
    expect(seen.codes).toEqual(['damaged-project', 'unknown-format', 'unknown-style']);
    expect(apart(readFileSync(at('styled.rgba')), native.data)).toBeLessThanOrEqual(1);
    expect([seen.pages > 0, seen.lost]).toEqual([true, []]);
    for (let i = 1; i <= seen.pages; i += 1) {
      const drawn = PNG.sync.read(readFileSync(at(`album-${i}.png`)));
      const expected = PNG.sync.read(readFileSync(at(`native-0${i}.png`)));
      expect(apart(drawn.data, expected.data), `page ${i}`).toBeLessThanOrEqual(1);
    }
    const begins = (/** @type {string} */ name) => readFileSync(at(name)).subarray(0, 4).toString('latin1');
    expect(['page.png', 'page.pdf', 'page.webp'].map(begins)).toEqual(['\x89PNG', '%PDF', 'RIFF']);
    expect(begins('page.jpg').slice(0, 3)).toBe('\xff\xd8\xff');
  } finally {
    project.remove();
  }
});
