// @ts-check
/** The most common user flow, from photos to files, in every engine. */

import { pathToFileURL } from 'node:url';
import { PNG, SIX, becomes, expect, given, photos, test } from './hands.js';

const animations = (/** @type {string} */ name) => given(`oracles/data/animations/${name}`);

test('a page is made, shuffled, changed by hand, and there again after a reload', async ({ person }) => {
  await person.begin();
  const first = await person.picture();
  for (const name of ['Shuffle', 'Shuffle layout', 'Shuffle style', 'Shuffle photos']) {
    const before = await person.picture();
    await person.press(name);
    await expect.poll(() => person.picture(), name).not.toBe(before);
  }
  expect(await person.picture()).not.toBe(first);

  await person.tab('Layouts');
  await person.select('Family', 'grid');
  await person.take('Layouts', 'Four');
  expect(await person.shown()).toHaveLength(4);
  await person.take('Styles', 'Manga');
  const plain = await person.picture();
  await person.take('Styles', 'Noir');
  await expect.poll(() => person.picture()).not.toBe(plain);

  const panel = await person.one('group', 'Panel 2 of 4');
  await panel.click();
  await person.press('Crop');
  await person.press('Zoom in');
  await person.press('Zoom in');
  await person.press('Done');
  const near = await person.picture();
  await person.drag(panel, [40, 30]);
  await expect.poll(() => person.picture()).not.toBe(near);
  await person.driver.actions().sendKeys(person.Key.ESCAPE).perform();

  await person.say('GUTEN TAG');
  await person.kept();
  const [shown, picture] = [await person.shown(), await person.picture()];
  await person.reload();
  await person.one('button', /^Balloon: GUTEN TAG/);
  // The page is there before it is drawn.
  await person.idle();
  expect(await person.shown()).toEqual(shown);
  await becomes(() => person.picture(), picture);
  await person.press('Undo');
});

test('a slider of the designer changes a style, and the explorer invents some', async ({ person }) => {
  await person.begin();
  await person.click('button', 'Style designer');
  const drawn = async () => {
    const preview = await person.one('region', 'Preview');
    await expect.poll(() => preview.getAttribute('aria-busy')).toBe('false');
    return person.picture('.comparison-styled');
  };
  await person.click('button', 'Add block');
  await person.click('button', /\(Posterization\)/);
  const before = await drawn();
  const slider = await person.one('slider', undefined, ['list', 'Background layer']);
  await slider.sendKeys(person.Key.HOME);
  await expect.poll(drawn).not.toBe(before);
  await person.click('button', 'Use', ['region', 'Style designer']);
  await person.idle();

  // The first styles appear automatically.
  await person.click('button', 'Explore styles');
  await expect
    .poll(async () => (await person.all('listitem', undefined, ['region', 'Style explorer'])).length)
    .toBeGreaterThan(5);
  await person.click('button', 'Favourite', ['region', 'Style explorer']);
});

test('faces and animals are found', async ({ person }) => {
  await person.begin(photos('camera.jpg', 'cat.jpg', 'horses.jpg', 'macaw.jpg'), { detects: true });
  await person.click('button', 'More', ['toolbar', 'Panel tools']);
  await person.press('Show subjects');
  const labels = () =>
    person.inPage(() =>
      [...document.querySelectorAll('.page .subject-boxes rect')].map((box) => box.getAttribute('data-label')),
    );
  for (const name of ['face', 'cat', 'horse', 'bird']) await expect.poll(labels).toContain(name);
});

test('the page becomes files of every kind, and goes to the clipboard', async ({ person }) => {
  await person.begin();
  const png = PNG.sync.read((await person.savedAs('png')).bytes);
  expect([png.width, png.height]).toEqual([1240, 1754]);
  const heads = { pdf: '%PDF-', jpeg: '\xff\xd8\xff', webp: 'RIFF' };
  for (const [format, head] of Object.entries(heads)) {
    const { bytes } = await person.savedAs(format);
    expect(bytes.subarray(0, head.length).toString('latin1'), format).toBe(head);
    expect(bytes.length, format).toBeGreaterThan(20_000);
  }
  const project = await person.savedProject();
  expect(project.name).toMatch(/\.inkpanel$/);
  expect(project.bytes.subarray(0, 2).toString()).toBe('PK');
  await person.openExport();
  await person.select('Resolution', '0.5');
  await person.click('button', 'Copy to clipboard', ['dialog', 'Export']);
  await expect
    .poll(() =>
      person.inPage(() => [...document.querySelectorAll('[role=status]')].map(({ textContent }) => textContent).join()),
    )
    .toContain('copied to the clipboard');
});

test('films lie on the table', async ({ person }) => {
  await person.begin([given('videos/album.mp4'), given('videos/album.webm'), SIX[0]]);
  // Six shots of one second each give the minimum number of frames of a video. If the browser's player reads the video,
  // shots are not detected, and the number follows the duration.
  for (const name of [/^Use album\.mp4, 0:0/, /^Use album\.webm, 0:0/])
    await expect.poll(async () => (await person.all('checkbox', name)).length, String(name)).toBeGreaterThanOrEqual(8);
});

test('an AVIF photo has its colours', async ({ person }) => {
  await person.begin([given('oracles/data/foreign/plain.avif')]);
  await person.one('checkbox', 'Use plain.avif');
  // Left it has more blue, right more red.
  const more = () =>
    person.inPage(() => {
      const tile = document.querySelector('[aria-label="Use plain.avif"]')?.closest('li');
      const shown = /** @type {HTMLImageElement} */ (tile?.querySelector('img'));
      const [width, height] = [shown.naturalWidth, shown.naturalHeight];
      if (width === 0) return [];
      const copy = Object.assign(document.createElement('canvas'), { width, height });
      const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext('2d'));
      context.drawImage(shown, 0, 0);
      return [0.05, 0.95].map((x) => {
        const [red, , blue] = context.getImageData(Math.floor(width * x), height >> 1, 1, 1).data;
        return red > blue ? 'red' : red < blue ? 'blue' : 'neither';
      });
    });
  await expect.poll(more).toEqual(['blue', 'red']);
});

test('photos that come from few cameras are read', async ({ person }) => {
  const names = ['webp-lossy.webp', 'webp-lossless.webp', 'gif.gif'];
  await person.begin([...names.map((name) => given(`oracles/data/files/${name}`)), SIX[0]]);
  for (const name of names) await person.one('checkbox', `Use ${name}`);
});

test('the pictures of animations lie on the table', async ({ person }) => {
  await person.begin([animations('kept.gif'), animations('lossless.webp'), SIX[0]]);
  for (const name of [/^Use kept\.gif, 0:0/, /^Use lossless\.webp, 0:0/])
    await expect.poll(async () => (await person.all('checkbox', name)).length, String(name)).toBe(4);
});

test('shots and pages become films of a kind that the browser makes', async ({ person }) => {
  await person.begin(SIX.slice(0, 2));
  const ways = /** @type {const} */ ({ animatic: 'Seconds per shot', motion: 'Seconds per panel' });
  for (const [way, length] of Object.entries(ways)) {
    await person.openExport();
    await person.chooseFormat(way);
    const slider = await person.one('slider', length);
    await person.driver.executeScript(
      `arguments[0].value = '0.5'; arguments[0].dispatchEvent(new Event('input', { bubbles: true }))`,
      slider,
    );
    await expect
      .poll(() => person.inPage(() => document.querySelector('.animatic canvas')?.hasAttribute('data-shown') ?? false))
      .toBe(true);
    const { name, bytes } = await person.saved(() => person.click('button', 'Download'));
    const heads = { mp4: 'ftyp', webm: '\x1a\x45\xdf\xa3', gif: 'GIF89a' };
    const kind = /** @type {keyof typeof heads} */ (name.slice(name.lastIndexOf('.') + 1));
    expect(bytes.subarray(0, 12).toString('latin1'), way).toContain(heads[kind]);
    expect(bytes.length, way).toBeGreaterThan(10_000);
  }
});

test('panels from films move in an HTML comic', async ({ person }) => {
  await person.begin([given('videos/album.mp4')]);
  // A random style may draw subjects separately, and then its panels are not animated.
  await person.take('Styles', 'Adventure Album');
  const { path, bytes } = await person.savedAs('html');
  await person.driver.get(pathToFileURL(path).href);
  const found = bytes.toString().matchAll(/<image class="moving"[^>]*href="data:image\/webp;base64,([^"]+)"/g);
  const files = [...found].map(([, file]) => Buffer.from(file, 'base64'));
  expect(files.length).toBeGreaterThan(0);
  for (const file of files) {
    // Twelve frames per second, with shots of one second. The end dissolves into the beginning.
    expect(file.toString('latin1').split('ANMF').length - 1).toBeGreaterThanOrEqual(6);
    // Transparent parts of a frame show the previous frames. No frame is damaged.
    const [decoded, pixels] = await person.inPage(
      async (address) => {
        const picture = new Image();
        picture.src = /** @type {string} */ (address);
        await picture.decode();
        return [picture.complete, picture.naturalWidth * picture.naturalHeight];
      },
      `data:image/webp;base64,${file.toString('base64')}`,
    );
    expect(decoded).toBe(true);
    expect(pixels).toBeGreaterThan(10_000);
  }
});

test('an HTML comic is read from its file, panel by panel', async ({ person }) => {
  await person.begin();
  await person.say('READ ME');
  const { path } = await person.savedAs('html');
  await person.driver.get(pathToFileURL(path).href);
  await person.click('button', 'Panels');
  const panels = (await person.all('region', /^Page 1, panel \d: /)).length;
  expect(panels).toBeGreaterThan(1);
  const said = () => person.inPage(() => document.querySelector('[role=status]')?.textContent ?? '');
  /** Share of the screen that the panel fills along its limiting side, and whether it is completely visible. */
  const filled = (/** @type {number} */ panel) =>
    person.inPage((panel) => {
      const stage = /** @type {Element} */ (document.querySelector('main')).getBoundingClientRect();
      const shape = /** @type {Element} */ (
        document.querySelector(`.current .shape[data-panel="${panel}"] polygon`)
      ).getBoundingClientRect();
      const inside =
        shape.left > stage.left - 2 &&
        shape.right < stage.right + 2 &&
        shape.top > stage.top - 2 &&
        shape.bottom < stage.bottom + 2;
      return inside && Math.max(shape.width / stage.width, shape.height / stage.height) > 0.8;
    }, panel);
  for (let panel = 0; panel < panels; panel += 1) {
    await expect.poll(said).toContain(`Page 1, panel ${panel + 1}: `);
    await expect.poll(() => filled(panel), `panel ${panel + 1} fills the screen`).toBe(true);
    if (panel + 1 < panels) await person.click('button', 'Next');
  }
  await person.click('button', 'Text');
  await expect
    .poll(() => person.inPage(() => /** @type {HTMLElement} */ (document.body).innerText))
    .toContain('READ ME');
});
