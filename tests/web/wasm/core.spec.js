// @ts-check
import { expect, test } from '../../../www/testing.ts';
import { openCore } from './core.js';
import { inkpanel, picture, SIZE, stylizeNatively } from './native.js';

/** @typedef {{ id: string, input: string, params: object[] }} Block */
/** The objects that `openCore` and a test stored in the page. @type {any} */
let core;
/** @type {any} */
let painters;

test.beforeEach(async ({ page }) => openCore(page));

for (const catalogue of ['blocks', 'layouts', 'styles']) {
  test(`the ${catalogue} are those of the native build`, async ({ page }) => {
    const found = JSON.parse(await page.evaluate((name) => core[name](), catalogue));
    expect(found.length).toBeGreaterThan(0);
    expect(found).toEqual(JSON.parse(inkpanel(catalogue, '--json')));
  });
}

test('every style and every block gives the pixels of the native build, within 1', async ({ page }, info) => {
  const source = picture();
  /** @type {{ blocks: Block[], styles: any[] }} */
  const { blocks, styles } = await page.evaluate(() => ({
    blocks: JSON.parse(core.blocks()),
    styles: JSON.parse(core.styles()),
  }));
  await page.evaluate(async () => {
    const model = await fetch('/models/painters.onnx');
    Object.assign(globalThis, { painters: new Uint8Array(await model.arrayBuffer()) });
  });
  for (const style of [...blocks.map(styleOf), ...styles]) {
    const native = stylizeNatively(source, style, (name) => info.outputPath(name));
    const result = await page.evaluate(stylizeInPage, { style, rgba: source.data.toString('base64'), ...SIZE });
    const inBrowser = Buffer.from(result, 'base64');
    const worst = inBrowser.reduce((most, value, i) => Math.max(most, Math.abs(value - native.data[i])), 0);
    expect.soft(inBrowser.length, `style ${style.id}`).toBe(native.data.length);
    expect.soft(worst, `style ${style.id}`).toBeLessThanOrEqual(1);
  }
});

/**
 * Runs in the page. Pixels cross as base64, which is much faster than as lists of numbers.
 * @param {{ style: object, rgba: string, width: number, height: number }} job
 * @returns {string}
 */
function stylizeInPage({ style, rgba, width, height }) {
  const bytes = Uint8Array.from(atob(rgba), (character) => character.charCodeAt(0));
  const studio = new core.Studio();
  if (JSON.stringify(style).includes('"painter"')) studio.know_painters(painters);
  const result = studio.stylize(JSON.stringify(style), width, height, bytes);
  return btoa(Array.from(result, (byte) => String.fromCharCode(byte)).join(''));
}

/** A style of one block, after what its input needs. @param {Block} block */
function styleOf({ id, input }) {
  const before = input === 'luma' ? [{ block: 'to_gray' }] : [];
  return { id: `only-${id.replaceAll('_', '-')}`, name: id, background: [...before, { block: id }] };
}

test('bad input is an error with a code and a sentence', async ({ page }) => {
  const thrown = await page.evaluate(() => {
    const studio = new core.Studio();
    const attempts = {
      noImage: () => studio.import_photo('a', new Uint8Array([1, 2, 3])),
      noStyle: () =>
        studio.stylize('{"id":"x","name":"X","background":[{"block":"nonsense"}]}', 1, 1, new Uint8Array(4)),
      wrongSize: () => studio.stylize('{"id":"x","name":"X","background":[]}', 2, 2, new Uint8Array(4)),
      noPhoto: () => studio.photo_planes('nobody/work'),
      noDocument: () => studio.compose('{', 100, 'work'),
      noLayout: () => core.check_layout('[]', 'mine.json'),
    };
    return Object.entries(attempts).map(([name, attempt]) => {
      try {
        attempt();
        return { name, code: 'nothing was thrown', message: '' };
      } catch (/** @type {any} */ error) {
        return { name, code: error.code, message: error.message, isError: error instanceof Error };
      }
    });
  });
  for (const { name, code, message, isError } of thrown) {
    expect.soft(code, name).toMatch(/^[a-z]+(-[a-z]+)+$/);
    expect.soft(message, name).toMatch(/\S+ \S+/);
    expect.soft(isError, name).toBe(true);
  }
  expect(thrown.find(({ name }) => name === 'noLayout')?.message).toContain('mine.json');
});

test('after an error the same studio goes on', async ({ page }) => {
  const size = await page.evaluate(() => {
    const studio = new core.Studio();
    try {
      studio.import_photo('a', new Uint8Array(100));
    } catch {
      // As expected.
    }
    studio.put_photo('b/work', 2, 1, new Uint8Array([10, 20, 30, 40, 50, 60]));
    return [studio.photo_bytes(), ...studio.photo_planes('b/work')];
  });
  expect(size).toEqual([6, 10, 20, 30, 40, 50, 60]);
});

test('after a trap a new instance of the same module works', async ({ page }) => {
  const { trap, after } = await page.evaluate(async () => {
    const module = await WebAssembly.compileStreaming(fetch('/pkg/inkpanel_bg.wasm'));
    const instance = async (/** @type {number} */ n) => {
      const fresh = await import(/** @type {any} */ (`/pkg/inkpanel.js?instance=${n}`));
      return { fresh, exports: await fresh.default({ module_or_path: module }) };
    };
    const first = await instance(1);
    let trap = null;
    try {
      // An object at an address outside the memory.
      first.exports.studio_photo_bytes(0xfffffff0);
    } catch (error) {
      trap = error instanceof WebAssembly.RuntimeError;
    }
    return { trap, after: JSON.parse((await instance(2)).fresh.styles()).length };
  });
  expect(trap).toBe(true);
  expect(after).toBeGreaterThan(0);
});
