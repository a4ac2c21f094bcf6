// @ts-check
/** The native command line, which the module must agree with, and the picture that both are given. */

import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { PNG } from '../../../www/testing.ts';

export const SIZE = { width: 97, height: 67 };

/** Gradients, hard edges, flat areas and grain, always the same. @returns {PNG} */
export function picture() {
  const png = new PNG({ ...SIZE });
  let seed = 7;
  for (let y = 0; y < SIZE.height; y += 1) {
    for (let x = 0; x < SIZE.width; x += 1) {
      seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
      const disc = Math.hypot(x - 60, y - 30) < 20;
      const grain = y > 40 ? (seed >>> 27) - 16 : 0;
      const rgb = disc ? [230, 60, 40] : [x * 2.5 + grain, 255 - y * 3 + grain, 128 + 100 * Math.sin(x / 9) + grain];
      const at = 4 * (y * SIZE.width + x);
      rgb.forEach((value, channel) => (png.data[at + channel] = Math.max(0, Math.min(255, Math.round(value)))));
      png.data[at + 3] = 255;
    }
  }
  return png;
}

/** @param {string[]} args @returns {string} what it prints */
export function inkpanel(...args) {
  const program = process.env.INKPANEL;
  if (!program) throw new Error('INKPANEL must name the native program: run `cargo xtask test wasm`');
  return execFileSync(program, args, { encoding: 'utf8', maxBuffer: 1 << 26 });
}

/**
 * A picture in a style, by the native program.
 * @param {PNG} source
 * @param {object} style a style file
 * @param {(name: string) => string} path of a file of this test
 * @returns {PNG}
 */
export function stylizeNatively(source, style, path) {
  const [input, file, output] = [path('in.png'), path('style.json'), path('out.png')];
  writeFileSync(input, PNG.sync.write(source));
  writeFileSync(file, JSON.stringify(style));
  // Without a subject mask, as in the module.
  inkpanel('stylize', '--no-detect', '--style', file, input, '-o', output);
  return PNG.sync.read(readFileSync(output));
}
