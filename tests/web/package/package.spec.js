// @ts-check
import { execFileSync } from 'node:child_process';
import { copyFileSync, cpSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PNG, expect, test } from '../../../www/testing.ts';
import { inkpanel, picture, stylizeNatively } from '../wasm/native.js';
import { emptyProject, serve } from './project.js';

const from = createRequire(new URL('../../../www/package.json', import.meta.url));
/** @type {typeof import('../../../www/node_modules/esbuild')} */
const esbuild = from('esbuild');
/** @type {typeof import('../../../www/node_modules/webpack')} */
const webpack = from('webpack');

const PHOTOS = fileURLToPath(new URL('../../../www/public/samples/', import.meta.url));
const VITE = fileURLToPath(new URL('../../../www/node_modules/vite/bin/vite.js', import.meta.url));
const TSC = fileURLToPath(new URL('../../../www/node_modules/typescript/bin/tsc', import.meta.url));

/** @type {ReturnType<typeof emptyProject>} */
let project;
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;

test.beforeAll(async () => {
  project = emptyProject();
  server = await serve(project.folder);
});

test.afterAll(() => {
  server.close();
  project.remove();
});

test('the example page draws a photo as the native program does, within 1', async ({ page }, info) => {
  const photo = picture();
  copyFileSync(join(project.installed, 'example.html'), join(project.folder, 'index.html'));
  writeFileSync(join(project.folder, 'photo.png'), PNG.sync.write(photo));
  const comic = JSON.parse(readFileSync(new URL('../../../styles/comic.json', import.meta.url), 'utf8'));
  const native = stylizeNatively(photo, comic, (name) => info.outputPath(name));
  await page.goto(`${server.address}index.html`);
  const apart = async () => {
    const drawn = await page.locator('canvas').evaluate((canvas) => {
      const { width, height } = /** @type {HTMLCanvasElement} */ (canvas);
      return [
        .../** @type {HTMLCanvasElement} */ (canvas.getContext('2d')?.getImageData(0, 0, width, height).data ?? []),
      ];
    });
    return drawn.length === native.data.length
      ? drawn.reduce((most, value, i) => Math.max(most, Math.abs(value - native.data[i])), 0)
      : 255;
  };
  await expect.poll(apart, { timeout: 60_000 }).toBeLessThanOrEqual(1);
  expect(
    photo.data.some((value, i) => Math.abs(value - native.data[i]) > 30),
    'the style changes the photo',
  ).toBe(true);
});

test('all that is promised works, and asks for nothing but files of the package', async ({ page }) => {
  const photos = ['07-red-panda', '19-astronaut'].map((name) => `${name}.jpg`);
  photos.forEach((name) => copyFileSync(join(PHOTOS, name), join(project.folder, name)));
  writeFileSync(join(project.folder, 'empty.html'), '<!doctype html><link rel="icon" href="data:,">');
  /** @type {string[]} */
  const strangers = [];
  page.on(
    'request',
    (request) =>
      /^(blob|data):/.test(request.url()) || request.url().startsWith(server.address) || strangers.push(request.url()),
  );
  await page.goto(`${server.address}empty.html`);
  const seen = await page.evaluate(all, photos);
  expect(seen.catalogues.every((count) => count > 10)).toBe(true);
  expect(seen.chosen).toEqual([
    { group: 0, kept: true },
    { group: 1, kept: true },
  ]);
  expect(seen.fingerprints.every((fingerprint) => /^[0-9a-f]{16}$/.test(fingerprint))).toBe(true);
  expect(seen.labels).toContain('face');
  expect(seen.plain).toEqual([420, 594]);
  expect(seen.changed, 'pixels that words change').toBeGreaterThan(1000);
  expect(seen.kind).toBe('image/png');
  expect(seen.codes).toEqual(['unknown-style', 'cancelled', 'disposed']);
  expect(strangers).toEqual([]);
  expect(server.missing.filter((path) => path !== '/favicon.ico')).toEqual([]);
});

test('the element shows pages of a saved project, for the width that they have, and says what is wrong', async ({
  page,
}) => {
  const photos = ['07-red-panda', '19-astronaut'].map((name) => join(PHOTOS, `${name}.jpg`));
  const at = (/** @type {string} */ name) => join(project.folder, name);
  inkpanel('render', '--pages', '2', '--page-size', '800x1000', '-o', at('album.inkpanel'), ...photos);
  inkpanel('render', at('album.inkpanel'), '-o', at('leaf-%02d.png'));
  const element =
    "<inkpanel-page src='album.inkpanel' page='2' alt='Two animals' style='width: 400px'></inkpanel-page>";
  const script = "<script type='module' src='/node_modules/inkpanel/engine/page-element.js'></script>";
  const icon = "<link rel='icon' href='data:,'>";
  writeFileSync(
    at('element.html'),
    `<!doctype html>${icon}<script>addEventListener('error', (event) => {
    document.title = event.error.code;
  }, true)</script>${element}${script}`,
  );
  await page.goto(`${server.address}element.html`);
  const shown = page.getByRole('img', { name: 'Two animals' });
  await expect(shown).toBeVisible({ timeout: 60_000 });
  const host = page.locator('inkpanel-page');
  expect(await host.evaluate((node) => /** @type {any} */ (node).pages)).toBe(2);
  expect(await shown.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).width)).toBe(400);
  const drawn = () => shown.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
  const second = await drawn();
  await host.evaluate((node) => node.setAttribute('page', '1'));
  await expect.poll(drawn).not.toBe(second);
  await host.evaluate((node) => Object.assign(node, { style: 'width: 600px' }));
  await expect
    .poll(() => shown.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).width), { timeout: 30_000 })
    .toBe(600);
  await host.evaluate((node) => node.setAttribute('src', 'leaf-01.png'));
  await expect(host.locator('img')).toBeVisible();
  await host.evaluate((node) => node.setAttribute('src', 'element.html'));
  await expect(page).toHaveTitle('damaged-project');
});

/**
 * A project of strict TypeScript, what a bundler made of it, and the page that it draws.
 * @param {import('../../../www/testing.ts').Page} page
 * @param {(at: (name: string) => string, folder: string) => Promise<void> | void} bundle from `main.ts` and `index.html` into `dist`
 */
async function bundled(page, bundle) {
  const made = emptyProject();
  try {
    const at = (/** @type {string} */ name) => join(made.folder, name);
    copyFileSync(join(PHOTOS, '07-red-panda.jpg'), at('photo.jpg'));
    writeFileSync(at('index.html'), pageOf('main.ts'));
    copyFileSync(new URL('bundler-main.ts', import.meta.url), at('main.ts'));
    const options = ['--noEmit', '--strict', '--target', 'es2022', '--lib', 'es2023,dom', '--types', ''];
    const resolution = ['--module', 'esnext', '--moduleResolution', 'bundler'];
    execFileSync(process.execPath, [TSC, ...options, ...resolution, 'main.ts'], { cwd: made.folder, stdio: 'inherit' });
    await bundle(at, made.folder);
    copyFileSync(at('photo.jpg'), at('dist/photo.jpg'));
    const built = await serve(at('dist'));
    try {
      await page.goto(`${built.address}index.html`);
      await expect(page).toHaveTitle('840 x 1188, undone', { timeout: 60_000 });
      expect(built.missing).toEqual([]);
    } finally {
      built.close();
    }
  } finally {
    made.remove();
  }
}

/** @param {string} script @param {string} [head] HTML before the script */
const pageOf = (script, head = '') =>
  `<!doctype html><link rel='icon' href='data:,'>${head}<script type='module' src='${script}'></script>`;

test('a project of Vite is built, and draws', async ({ page }) =>
  bundled(page, (at, folder) => {
    writeFileSync(at('vite.config.mjs'), "export default { worker: { format: 'es' }, build: { target: 'esnext' } };");
    execFileSync(process.execPath, [VITE, 'build', '--logLevel', 'error'], { cwd: folder, stdio: 'inherit' });
  }));

test('a project of webpack is built, and draws', async ({ page }) =>
  bundled(page, async (at, folder) => {
    // Its types are TypeScript's work, done by then.
    await esbuild.build({ entryPoints: [at('main.ts')], outfile: at('main.js'), format: 'esm', target: 'es2022' });
    const compiler = webpack({ mode: 'production', context: folder, entry: './main.js', output: { path: at('dist') } });
    const stats = await new Promise((resolve, reject) =>
      compiler?.run((error, done) => (error ? reject(error) : resolve(done))),
    );
    expect(stats.toJson({ all: false, errors: true }).errors).toEqual([]);
    writeFileSync(at('dist/index.html'), pageOf('main.js'));
  }));

test('a project of esbuild is built with the package beside it, and draws', async ({ page }) =>
  bundled(page, async (at, folder) => {
    const common = /** @type {const} */ ({ bundle: true, format: 'esm', target: 'es2022', packages: 'external' });
    await esbuild.build({ entryPoints: [at('main.ts')], outfile: at('dist/main.js'), ...common });
    // It does not change `new URL(file, import.meta.url)`, so the package's files need no change.
    cpSync(join(folder, 'node_modules/inkpanel'), at('dist/inkpanel'), { recursive: true });
    const imports = { inkpanel: './inkpanel/engine/index.js', 'inkpanel/element': './inkpanel/engine/page-element.js' };
    writeFileSync(
      at('dist/index.html'),
      pageOf('main.js', `<script type='importmap'>${JSON.stringify({ imports })}</script>`),
    );
  }));

/** Runs in the page. @param {string[]} names of two photos */
async function all(names) {
  const { createEngine } = await import(/** @type {any} */ ('/node_modules/inkpanel/engine/index.js'));
  /** @type {import('../../../www/engine/engine.ts').Engine} */
  const engine = createEngine({ workers: 2 });
  const blobs = await Promise.all(names.map(async (name) => (await fetch(name)).blob()));
  const catalogues = (await Promise.all([engine.blocks(), engine.layouts(), engine.styles()])).map(
    ({ length }) => length,
  );
  const verdicts = await engine.select(blobs);
  const found = await engine.detect(blobs[1]);
  const photos = await Promise.all(blobs.map((blob, i) => engine.importPhoto(`photo-${i}`, blob)));
  const page = {
    width: 420,
    height: 594,
    dpi: 96,
    gutter: 0.02,
    margin: 0.03,
    border: 0.004,
    cornerRadius: 0,
    paper: '#ffffff',
    borderColor: '#101014',
  };
  const keep = { layout: false, style: false, photos: false };
  const document = (await engine.ready).plan({ seed: 7, photos, page, current: null, keep, style: 'comic', panels: 2 });
  const plain = await engine.compose(document, { width: 420 });
  const words = [{ kind: /** @type {const} */ ('caption'), text: 'Meanwhile, in an empty project', panel: 0 }];
  const lettered = await engine.compose({ ...document, words }, { width: 420 });
  const png = await engine.exportPng(document);
  const code = (/** @type {Promise<any>} */ promise) =>
    promise.then(
      () => 'done',
      (error) => error.code,
    );
  const picture = { width: 1, height: 1, data: new Uint8ClampedArray(4), style: 'no-such-style' };
  const stopped = AbortSignal.abort();
  const codes = [await code(engine.stylize(picture)), await code(engine.detect(blobs[0], { signal: stopped }))];
  engine.dispose();
  codes.push(await code(engine.stylize(picture)));
  return {
    catalogues,
    codes,
    kind: png.type,
    plain: [plain.width, plain.height],
    chosen: verdicts.map(({ group, kept }) => ({ group, kept })),
    fingerprints: verdicts.map(({ fingerprint }) => fingerprint),
    labels: found.map(({ label }) => label),
    changed: plain.data.reduce((count, value, i) => count + Number(value !== lettered.data[i]), 0),
  };
}

for (const resolution of ['bundler', 'nodenext']) {
  test(`TypeScript takes its types, resolved by ${resolution}`, () => {
    copyFileSync(new URL('use.ts', import.meta.url), join(project.folder, 'use.ts'));
    const module = resolution === 'nodenext' ? 'nodenext' : 'esnext';
    writeFileSync(join(project.folder, 'package.json'), '{ "private": true, "type": "module" }');
    const options = [
      '--noEmit',
      '--strict',
      '--target',
      'es2022',
      '--lib',
      'es2023,dom',
      '--types',
      '',
      '--module',
      module,
      '--moduleResolution',
      resolution,
    ];
    execFileSync(process.execPath, [TSC, ...options, 'use.ts'], { cwd: project.folder, stdio: 'inherit' });
  });
}
