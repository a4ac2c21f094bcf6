// @ts-check
/** Storyboards: shots that are typed, pasted and imported, sheets, and shot lists. */

import { execFile } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import { promisify } from 'node:util';
import { probed } from '../video-files.js';
import { chooseFormat, openExport, saved } from '../export-dialog.js';
import { reloadSaved } from '../project-files.js';
import {
  accessible,
  expect,
  idle,
  openBoard,
  openStart,
  PNG,
  photos,
  SIX,
  sharedBoardTest as test,
} from '../support.js';
import { write } from '../text-items.js';

/** @typedef {import('../support.js').Page} Page */

const run = promisify(execFile);

/** @param {Page} page */
async function openShots(page) {
  await page.getByRole('button', { name: 'Storyboard', exact: true }).click();
  const shots = page.getByRole('region', { name: 'Shots' });
  await expect(shots.getByRole('textbox', { name: 'Action, shot 1' })).toBeVisible();
  return shots;
}

/** @param {Page} page */
async function drawn(page) {
  const sheets = page.getByRole('region', { name: 'Storyboard sheets' });
  await expect(sheets.getByRole('list')).toHaveAttribute('aria-busy', 'false');
  await sheets.getByRole('img').first().scrollIntoViewIfNeeded();
  await expect(sheets.locator('canvas[data-drawn=true]').first()).toBeVisible();
  return sheets;
}

test.describe('on a tablet', () => {
  test.use({ viewport: { width: 820, height: 1180 }, hasTouch: true });

  test('the buttons that move a shot are visible, also with another column, and fields suit a finger', async ({
    page,
  }) => {
    await openBoard(page, SIX);
    await page.getByRole('button', { name: 'Menu' }).click();
    const shots = await openShots(page);
    const last = shots.locator('.shot-tools').first().getByRole('button').last();
    const end = async () => {
      const box = await last.boundingBox();
      return (box?.x ?? 0) + (box?.width ?? 820);
    };
    expect(await end()).toBeLessThanOrEqual(820);
    expect((await page.getByRole('textbox', { name: 'By', exact: true }).boundingBox())?.height).toBe(44);
    const list = page.locator('.shots-scroll');
    expect(await list.evaluate((all) => all.scrollWidth - all.clientWidth)).toBe(0);
    await page.getByPlaceholder('New column').fill('Camera');
    await page.keyboard.press('Enter');
    await expect(shots.getByRole('textbox', { name: 'Camera, shot 1' })).toBeAttached();
    expect(await end()).toBeLessThanOrEqual(820);
  });
});

test('keyboard: photos are added, fields are typed, and the board and the shot list are saved', async ({ page }) => {
  await openStart(page);
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Choose photos or a video' }).press('Enter');
  await (await chooser).setFiles(await photos(...SIX));
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await page.getByRole('button', { name: 'Storyboard', exact: true }).press('Enter');

  const shots = page.getByRole('region', { name: 'Shots' });
  await shots.getByRole('textbox', { name: 'Scene, shot 1' }).focus();
  const { keyboard } = page;
  // Tab moves to the next field, Enter to the next shot.
  await keyboard.type('1');
  await keyboard.press('Tab');
  await keyboard.press('Tab');
  await keyboard.type('1:12');
  await keyboard.press('Tab');
  await keyboard.type('She opens the door.');
  await keyboard.press('Enter');
  await expect(shots.getByRole('textbox', { name: 'Action, shot 2' })).toBeFocused();
  await keyboard.type('The cat watches.');
  await keyboard.press('Tab');
  await keyboard.type('Is anybody there?');
  await keyboard.press('Shift+Tab');
  await keyboard.press('Shift+Tab');
  await keyboard.press('Shift+Tab');
  await keyboard.type('1A');
  await keyboard.press('Enter');
  // Shots without a number skip a number that was typed.
  await expect(shots.getByRole('textbox', { name: 'Action, shot 1A' })).toHaveValue('The cat watches.');
  await expect(shots.getByRole('textbox', { name: 'Shot, shot 2' })).toBeFocused();
  // Escape discards the typed text.
  await keyboard.type('99');
  await keyboard.press('Escape');
  await expect(shots.getByRole('textbox', { name: 'Shot, shot 2' })).toHaveValue('');
  await expect(shots).toContainText('11 s 12 f');

  const ways = page.getByRole('combobox', { name: 'Save as' });
  const board = await saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).press('Enter'));
  expect(board.name).toMatch(/\.pdf$/);
  const text = (await run('pdftotext', ['-raw', board.path, '-'])).stdout.replace(/\s+/g, ' ');
  for (const said of ['She opens the door.', 'Dialogue: Is anybody there?', '1A', 'Page 1 of 1'])
    expect(text).toContain(said);
  await ways.focus();
  await keyboard.press('ArrowDown');
  await keyboard.press('ArrowDown');
  await expect(ways).toHaveValue('csv');
  const list = await saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).press('Enter'));
  const lines = (await readFile(list.path, 'utf8')).split('\r\n');
  expect(lines[0]).toBe('\ufeffScene,Shot,Picture,Film,Time code,Duration,Frames,Action,Dialogue,Notes');
  expect(lines[1]).toMatch(/^1,1,[^,]+\.jpg,,,00:00:01:12,36,She opens the door\.,,$/);
  expect(lines[2]).toMatch(/^,1A,[^,]+\.jpg,,,00:00:02:00,48,The cat watches\.,Is anybody there\?,$/);
  expect(lines).toHaveLength(8);
  // Shuffle on the comic page does not change the fields.
  await page.getByRole('button', { name: 'Comic', exact: true }).press('Enter');
  await page.getByRole('button', { name: 'Shuffle', exact: true }).press('Enter');
  await idle(page);
  await page.getByRole('button', { name: 'Storyboard', exact: true }).press('Enter');
  await expect(shots.getByRole('textbox', { name: 'Action, shot 1A' })).toHaveValue('The cat watches.');
});

test('dialogue, captions and sounds of the pages have a column each, and a label on the sheets', async ({ page }) => {
  await openBoard(page);
  for (const [kind, text] of [
    ['balloon', 'Who is there?'],
    ['caption', 'Later'],
    ['sound effect', 'BANG'],
  ])
    await write(page, kind, text);
  await openShots(page);
  const filled = async (/** @type {string} */ column) => {
    const cells = page.getByRole('textbox', { name: new RegExp(`^${column}, shot`) });
    return (
      await cells.evaluateAll((all) => all.map((cell) => /** @type {HTMLTextAreaElement} */ (cell).value))
    ).filter((text) => text !== '');
  };
  expect([await filled('Dialogue'), await filled('Caption'), await filled('Sound')]).toEqual([
    ['Who is there?'],
    ['Later'],
    ['BANG'],
  ]);
  await drawn(page);
  const board = await saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).click());
  const text = (await run('pdftotext', ['-raw', board.path, '-'])).stdout.replace(/\s+/g, ' ');
  for (const said of ['Dialogue: Who is there?', 'Caption: Later', 'Sound: BANG']) expect(text).toContain(said);
  await page.getByRole('combobox', { name: 'Save as' }).selectOption('csv');
  const list = await saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).click());
  const [head] = (await readFile(list.path, 'utf8')).split('\r\n');
  expect(head.split(',').slice(8)).toEqual(['Dialogue', 'Caption', 'Sound', 'Notes']);
});

test('Export begins with the storyboard on its view, and with the comic elsewhere', async ({ page }) => {
  await openBoard(page);
  const comic = await openExport(page);
  await expect(comic.getByRole('radio', { name: 'Storyboard', exact: true })).toHaveCount(0);
  await chooseFormat(comic, 'jpeg');
  await page.keyboard.press('Escape');
  const shots = await openShots(page);
  await shots.getByRole('textbox', { name: 'Action, shot 1' }).fill('She opens the door.');
  await shots.getByRole('textbox', { name: 'Action, shot 1' }).press('Enter');
  await drawn(page);
  const dialog = await openExport(page);
  await expect(dialog.getByRole('radio', { name: 'Storyboard', exact: true })).toBeChecked();
  await expect(dialog.getByRole('radio', { name: 'Storyboard, PDF' })).toBeChecked();
  await expect(dialog.getByText('All sheets of the storyboard')).toBeVisible();
  const board = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  expect((await run('pdftotext', ['-raw', board.path, '-'])).stdout).toContain('She opens the door.');
  await page.getByRole('button', { name: 'Comic', exact: true }).click();
  await openExport(page);
  await expect(comic.getByRole('radio', { name: 'JPEG', exact: true })).toBeChecked();
  await expect(comic.getByRole('radio', { name: 'Storyboard', exact: true })).toHaveCount(0);
});

test('keyboard: a video becomes a board and an animatic', async ({ page }) => {
  await openStart(page);
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Choose photos or a video' }).press('Enter');
  const buffer = await readFile(new URL('../../../videos/album.mp4', import.meta.url));
  await (await chooser).setFiles([{ name: 'album.mp4', mimeType: 'video/mp4', buffer }]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await idle(page);
  await page.getByRole('button', { name: 'Storyboard', exact: true }).press('Enter');
  const shots = page.getByRole('region', { name: 'Shots' });
  const actions = shots.getByRole('textbox', { name: /^Action, shot/ });
  await expect(actions.nth(1)).toBeVisible();
  const count = await actions.count();
  await actions.first().focus();
  await page.keyboard.type('It begins.');
  await page.keyboard.press('Enter');
  await expect(actions.nth(1)).toBeFocused();
  const board = await saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).press('Enter'));
  const { stdout } = await run('pdftotext', ['-raw', board.path, '-']);
  expect(stdout).toContain('It begins.');
  await page.getByRole('button', { name: 'Animatic', exact: true }).press('Enter');
  const dialog = page.getByRole('dialog');
  await dialog.getByRole('slider', { name: 'Seconds per shot' }).focus();
  await page.keyboard.press('Home');
  await dialog.getByRole('combobox', { name: 'Size' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(dialog.getByRole('combobox', { name: 'Size' })).toHaveValue('720p');
  // Frames that look like the frame before are left out.
  const leftOut = dialog.getByRole('checkbox', { name: /^Leave out/ });
  if (await leftOut.isVisible()) await leftOut.press(' ');
  await expect(dialog.getByText(`${count} shots, 0:`)).toBeVisible();
  const film = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).press('Enter'));
  expect(film.name).toMatch(/\.mp4$/);
  const { streams } = await probed(film.path);
  expect(streams[0]).toMatchObject({ width: 1280, height: 720, nb_read_frames: String(12 * count) });
});

test('spreadsheet cells are pasted, shots are moved, and a custom column is added and removed', async ({ page }) => {
  await openBoard(page);
  const shots = await openShots(page);
  const cell = (/** @type {string} */ name) => shots.getByRole('textbox', { name, exact: true });
  await shots.getByRole('textbox', { name: 'New column' }).fill('Lens');
  await shots.getByRole('textbox', { name: 'New column' }).press('Enter');
  await expect(cell('Lens, shot 1')).toBeVisible();
  await cell('Notes, shot 2').focus();
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.setData('text/plain', 'dusk\t35\ndawn\t50\t!\n');
    document.activeElement?.dispatchEvent(
      new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }),
    );
  });
  await expect(cell('Notes, shot 3')).toHaveValue('dawn');
  await expect(cell('Lens, shot 2')).toHaveValue('35');
  await expect(page.getByRole('alert')).toContainText('1 pasted cell was outside the table and was ignored.');
  // A move changes the numbers. The fields stay with their photo.
  await cell('Notes, shot 3').press('Alt+ArrowUp');
  await expect(cell('Notes, shot 2')).toHaveValue('dawn');
  await expect(cell('Notes, shot 2')).toBeFocused();
  await shots.getByRole('button', { name: 'Move shot 2 up' }).click();
  await expect(cell('Lens, shot 1')).toHaveValue('50');
  await cell('Length, shot 1').fill('soon');
  await cell('Length, shot 1').press('Enter');
  await expect(page.getByRole('alert').filter({ hasText: 'soon' })).toBeVisible();
  await shots.getByRole('button', { name: 'Remove column Lens' }).click();
  await expect(cell('Lens, shot 1')).toHaveCount(0);
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(cell('Lens, shot 1')).toHaveValue('50');
});

test('a drag of its handle moves a shot in the list, as one undo step', async ({ page }) => {
  await openBoard(page);
  const shots = await openShots(page);
  const names = () =>
    shots.locator('.shot-picture').evaluateAll((list) => list.map((one) => one.getAttribute('title')?.split('\n')[0]));
  const [first, second, third, ...rest] = await names();
  const middle = async (/** @type {number} */ n) => {
    const box = await shots.locator('.shot-handle').nth(n).boundingBox();
    if (!box) throw new Error(`no shot ${n}`);
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  // Rows are about as high as their pictures.
  const row = await shots.locator('tbody tr').nth(1).boundingBox();
  const frame = await shots.locator('tbody .shot-picture').nth(1).boundingBox();
  expect(row?.height).toBeLessThan((frame?.height ?? 0) + 12);
  const [[x, from], [, to]] = [await middle(2), await middle(0)];
  await page.mouse.move(x, from);
  await page.mouse.down();
  await page.mouse.move(x, (from + to) / 2, { steps: 3 });
  await page.mouse.move(x, to - 12, { steps: 3 });
  await expect(shots.locator('tr[data-marked=before]')).toHaveCount(1);
  await page.mouse.up();
  expect(await names()).toEqual([third, first, second, ...rest]);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await names()).toEqual([first, second, third, ...rest]);
});

test('a screenplay fills scenes, action and dialogue as one undo step, and lines without a shot are reported', async ({
  page,
}) => {
  await openBoard(page);
  const shots = await openShots(page);
  const more = Array.from({ length: 6 }, (_, i) => `Action number ${i + 1}.`).join('\n\n');
  const script = `INT. CORRIDOR - NIGHT\n\nShe opens the door.\n\nANNA\nIs anybody there?\n\n${more}\n`;
  await page
    .locator('input[aria-label="Import script or table"]')
    .setInputFiles({ name: 'night.fountain', mimeType: 'text/plain', buffer: Buffer.from(script) });
  const cell = (/** @type {string} */ name) => shots.getByRole('textbox', { name, exact: true });
  await expect(cell('Scene, shot 6')).toHaveValue('INT. CORRIDOR - NIGHT');
  await expect(cell('Dialogue, shot 1')).toHaveValue('ANNA: Is anybody there?');
  await expect(
    page.getByRole('alert').filter({ hasText: '1 line did not match any shot: “Action number 6.”' }),
  ).toBeVisible();
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(cell('Scene, shot 6')).toHaveValue('');
  await expect(cell('Dialogue, shot 1')).toHaveValue('');
});

test('tables and screenplays of other programs are read as they are meant', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 3));
  const shots = await openShots(page);
  const cell = (/** @type {string} */ name) => shots.getByRole('textbox', { name, exact: true });
  const take = (/** @type {string} */ name, /** @type {string} */ text) =>
    page
      .locator('input[aria-label="Import script or table"]')
      .setInputFiles({ name, mimeType: 'text/plain', buffer: Buffer.from(text, 'latin1') });
  // As Excel saves it in German, with the numbers of the production.
  await take('liste.csv', 'sep=;\r\nSzene;Einstellung;Dauer;Handlung\r\n1;101;2:12;Öffnet die Tür\r\n1;102;;Geht\r\n');
  await expect(cell('Action, shot 101')).toHaveValue('Öffnet die Tür');
  await expect(cell('Length, shot 101')).toHaveValue('2 s 12 f');
  await expect(cell('Shot, shot 102')).toHaveValue('102');
  await expect(shots.getByRole('textbox', { name: /^sep=/ })).toHaveCount(0);
  await expect(page.getByRole('alert').filter({ hasText: 'liste.csv: it is not UTF-8' })).toBeVisible();
  await take('song.fountain', 'SINGER\n~These are the songs\n~That I sing.\n\nShe bows. [[low]]\n');
  await expect(cell('Dialogue, shot 101')).toHaveValue('SINGER: These are the songs That I sing.');
  await expect(cell('Action, shot 102')).toHaveValue('She bows.');
  await take('photo.csv', '\x89PNG\r\n\x1a\n\0\0\0\r');
  await expect(page.getByRole('alert').filter({ hasText: 'photo.csv: it is not a text file' })).toBeVisible();
});

test('the sheets have the chosen layout and number of frames', async ({ page }) => {
  await openBoard(page);
  await openShots(page);
  const sheets = await drawn(page);
  await expect(sheets.getByRole('img', { name: 'Sheet 1 of 1' })).toBeVisible();
  await sheets.getByRole('combobox', { name: 'Frames per sheet' }).selectOption('4');
  await expect(sheets.getByRole('img', { name: 'Sheet 2 of 2' })).toBeAttached();
  await sheets.getByRole('button', { name: 'Grey film style' }).click();
  await expect(sheets.getByRole('img', { name: 'Sheet 1 of 1' })).toBeVisible();
  await expect(sheets.getByRole('combobox', { name: 'Frames per sheet' })).toHaveValue('6');
});

/**
 * Returns an image file of one colour.
 * @param {string} name
 * @param {{ width: number, height: number }} size
 * @param {readonly [number, number, number, number]} rgba
 */
function picture(name, { width, height }, rgba) {
  const png = new PNG({ width, height });
  for (let i = 0; i < png.data.length; i += 4) png.data.set(rgba, i);
  return { name, mimeType: 'image/png', buffer: PNG.sync.write(png) };
}

/**
 * @param {import('../support.js').Page} page
 * @returns the colour in the middle of a square logo on the first sheet
 */
function logoColour(page) {
  const canvas = page.getByRole('region', { name: 'Storyboard sheets' }).locator('canvas').first();
  return canvas.evaluate((element) => {
    const shown = /** @type {HTMLCanvasElement} */ (element);
    const context = new OffscreenCanvas(shown.width, shown.height).getContext('2d');
    if (!context) throw new Error('no context');
    context.drawImage(shown, 0, 0);
    // 15.5 mm from the corner of A4, in portrait or landscape orientation.
    const at = Math.round((15.5 / (shown.width > shown.height ? 297 : 210)) * shown.width);
    return [...context.getImageData(at, at, 1, 1).data.slice(0, 3)].join(' ');
  });
}

/** @param {string} path of a PDF file */
async function imagesIn(path) {
  const { stdout } = await run('pdfimages', ['-list', path]);
  return stdout.trim().split('\n').length - 2;
}

test('a logo is in the head of each sheet, can be undone, and is stored and saved', async ({ page }) => {
  await openBoard(page);
  await openShots(page);
  const sheets = await drawn(page);
  const save = () => saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).click());
  const before = await imagesIn((await save()).path);
  const group = sheets.getByRole('group', { name: 'Logo' });
  const file = group.locator('input[type=file]');
  const shown = group.getByRole('img', { name: 'Logo' });
  const [red, blue] = ['220 20 30', '20 60 200'];
  await expect(group.getByRole('button', { name: 'Remove the logo' })).toHaveCount(0);
  expect(await logoColour(page)).not.toBe(red);

  const chooser = page.waitForEvent('filechooser');
  await group.getByRole('button', { name: 'Choose a logo' }).press('Enter');
  await (await chooser).setFiles(picture('logo.png', { width: 40, height: 40 }, [220, 20, 30, 255]));
  await expect(shown).toBeVisible();
  await expect.poll(() => logoColour(page)).toBe(red);
  await accessible(page);
  const board = await save();
  expect(await imagesIn(board.path)).toBe(before + 1);
  const { stdout: read } = await run('pdfinfo', ['-struct-text', board.path]);
  expect(read).toContain('Figure');

  // Transparent pixels are white. A large image is scaled down.
  await file.setInputFiles(picture('clear.png', { width: 900, height: 900 }, [0, 0, 0, 0]));
  await expect.poll(() => logoColour(page)).toBe('255 255 255');
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg" width="8" height="8"><rect width="8" height="8" fill="rgb(20,60,200)"/></svg>';
  await file.setInputFiles({ name: 'logo.svg', mimeType: 'image/svg+xml', buffer: Buffer.from(svg) });
  await expect.poll(() => logoColour(page)).toBe(blue);
  const undo = page.getByRole('button', { name: 'Undo', exact: true });
  await undo.click();
  await undo.click();
  await expect.poll(() => logoColour(page)).toBe(red);
  await undo.click();
  await expect(shown).toHaveCount(0);
  await expect.poll(() => logoColour(page)).not.toBe(red);
  await page.getByRole('button', { name: 'Redo', exact: true }).click();
  await expect.poll(() => logoColour(page)).toBe(red);

  await file.setInputFiles({ name: 'words.png', mimeType: 'image/png', buffer: Buffer.from('a logo') });
  await expect(page.getByRole('alert').filter({ hasText: 'words.png is not an image' })).toBeVisible();
  await expect(shown).toBeVisible();

  await reloadSaved(page);
  await openShots(page);
  await drawn(page);
  await expect.poll(() => logoColour(page)).toBe(red);
  await group.getByRole('button', { name: 'Remove the logo' }).click();
  await expect(shown).toHaveCount(0);
  await expect(group.getByRole('button', { name: 'Choose a logo' })).toBeFocused();
  await expect.poll(() => logoColour(page)).not.toBe(red);
});

test('a logo of many colours is scaled down to the size limit', async ({ page }) => {
  await openBoard(page);
  await openShots(page);
  await drawn(page);
  const group = page.getByRole('group', { name: 'Logo' });
  const noise = new PNG({ width: 1200, height: 500 });
  for (let i = 0, seed = 1; i < noise.data.length; i += 1) {
    seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
    noise.data[i] = i % 4 === 3 ? 255 : seed >>> 24;
  }
  await group
    .locator('input[type=file]')
    .setInputFiles({ name: 'noise.png', mimeType: 'image/png', buffer: PNG.sync.write(noise) });
  const shown = group.getByRole('img', { name: 'Logo' });
  await expect(shown).toBeVisible();
  const [width, height] = await shown.evaluate((image) => {
    const { naturalWidth, naturalHeight } = /** @type {HTMLImageElement} */ (image);
    return [naturalWidth, naturalHeight];
  });
  // Noise needs about three bytes per pixel. The limit is 64 kB of text.
  expect(width).toBeGreaterThan(150);
  expect(width).toBeLessThan(250);
  expect(Math.abs(width / height - 2.4)).toBeLessThan(0.05);
});

test('Export saves four formats of shot lists', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('button', { name: 'Export', exact: true }).click();
  const dialog = page.getByRole('dialog');
  for (const [name, start] of [
    ['csv', '\ufeffScene,'],
    ['edl', 'TITLE: '],
    ['otio', '{'],
    ['xml', '<?xml'],
  ]) {
    if (!(await dialog.isVisible())) await page.getByRole('button', { name: 'Export', exact: true }).click();
    await chooseFormat(dialog, name);
    const { path } = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
    expect((await readFile(path, 'utf8')).startsWith(start), name).toBe(true);
  }
});

test('a drop-frame rate changes lengths and lists, as one undo step', async ({ page }) => {
  await openBoard(page);
  const shots = await openShots(page);
  const length = shots.getByRole('textbox', { name: 'Length, shot 1' });
  await length.fill('1:00:02');
  await length.press('Enter');
  await expect(length).toHaveValue('1 min 2 f');
  const rate = page.getByRole('combobox', { name: 'Frames per second' });
  const names = await rate.getByRole('option').allTextContents();
  expect(names).toEqual(['23.976', '24', '25', '29.97 NDF', '29.97 DF', '30']);
  await rate.selectOption('29.97 DF');
  // 1:00:02 at 24 is 1803 frames at 30. Drop-frame timecode starts each minute at frame 2.
  await expect(length).toHaveValue('1:00;05');
  await page.getByRole('combobox', { name: 'Save as' }).selectOption('edl');
  const list = await saved(page, () => page.getByRole('button', { name: 'Save storyboard' }).click());
  const text = await readFile(list.path, 'utf8');
  expect(text).toContain('FCM: DROP FRAME');
  expect(text).toContain('00:00:00;00 00:01:00;05 01:00:00;00 01:01:00;05');
  await page.getByRole('button', { name: 'Undo', exact: true }).click();
  await expect(rate).toHaveValue('24');
  await expect(length).toHaveValue('1 min 2 f');
});

for (const size of [
  { width: 1366, height: 768 },
  { width: 360, height: 740 },
]) {
  test(`axe finds nothing in the shot list and the sheets, ${size.width} pixels wide, in light and dark`, async ({
    page,
  }) => {
    await openBoard(page);
    await page.setViewportSize(size);
    if (size.width < 1000) await page.getByRole('button', { name: 'Menu', exact: true }).click();
    await openShots(page);
    await drawn(page);
    for (const colorScheme of /** @type {const} */ (['light', 'dark'])) {
      await page.emulateMedia({ colorScheme });
      await accessible(page);
    }
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  });
}
