// @ts-check
/** Text items: captions, balloons and sound effects, by mouse and keyboard, from scripts and from subtitles. */

import { readFile } from 'node:fs/promises';
import { download } from '../export-dialog.js';
import { drag } from '../panels.js';
import {
  PNG,
  SIX,
  accessible,
  add,
  drop,
  expect,
  idle,
  makePageSmall,
  openBoard,
  openStart,
  press,
  tab,
  sharedBoardTest as test,
} from '../support.js';
import { box, drawnFill, inked, openWords, word, write } from '../text-items.js';

const VIDEO = new URL('../../../videos/album.mp4', import.meta.url);

test('text items are added, edited and drawn, and each step can be undone', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'HELLO');
  await expect(word(page, 'Balloon: HELLO')).toBeFocused();
  const one = await inked(page);
  expect(one.count).toBeGreaterThan(200);
  await write(page, 'caption', 'Later');
  await write(page, 'sound effect', 'BOOM');
  await expect(word(page, /: /)).toHaveCount(3);
  expect((await inked(page)).count).toBeGreaterThan(one.count);
  await accessible(page);
  // A new text item and its first text are one step.
  for (let i = 0; i < 3; i += 1) await press(page, 'Undo');
  await expect(word(page, /: /)).toHaveCount(0);
  await press(page, 'Redo');
  await expect(word(page, 'Balloon: HELLO')).toBeVisible();
});

test('while a text is typed, its drawn balloon has the place and size that it gets', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'Well.');
  const short = await inked(page);
  await page.keyboard.press('Enter');
  await page.keyboard.type('This text is much longer, so that the balloon needs more room and often another place.');
  await expect.poll(async () => (await inked(page)).count).toBeGreaterThan(1.5 * short.count);
  await idle(page);
  const typed = await inked(page);
  await page.keyboard.press('Enter');
  await idle(page);
  expect(await inked(page)).toEqual(typed);
});

test('the first and the last line of a typed text are inside the round outline', async ({ page }) => {
  await openBoard(page);
  await openWords(page);
  await page.getByRole('button', { name: 'Add balloon' }).click();
  const field = page.getByRole('textbox', { name: /^Text of/ });
  await expect(field).toBeFocused();
  const pads = [];
  for (const typed of 'This text is much longer so that the balloon needs more room and often another place'.split(
    ' ',
  )) {
    await page.keyboard.type(`${typed} `);
    pads.push(await field.evaluate((area) => Number.parseFloat(getComputedStyle(area).paddingTop) / area.clientHeight));
  }
  expect(Math.min(...pads)).toBeGreaterThan(0.04);
});

test('a title goes from one side of the page to the other, and Undo removes it', async ({ page }) => {
  await openBoard(page);
  await write(page, 'title', 'Summer');
  const [title, sheet] = [await box(word(page, 'Title: Summer')), await box(page.locator('.page'))];
  expect(title.width).toBeGreaterThan(0.9 * sheet.width);
  expect(title.y).toBeGreaterThanOrEqual(sheet.y - 1);
  await press(page, 'Undo');
  await expect(word(page, /: /)).toHaveCount(0);
});

test('a long text at the top stays on the page while the page becomes smaller', async ({ page }) => {
  await openBoard(page);
  await openWords(page);
  await page.getByRole('button', { name: 'Add balloon' }).click();
  const field = page.getByRole('textbox', { name: /^Text of/ });
  await expect(field).toBeFocused();
  await page.keyboard.insertText(
    'This text goes on and on, and it grows while a person types it into the balloon. '.repeat(2),
  );
  /** Pixels between the field and the nearest edge of the page. */
  const room = async () => {
    const [sheet, text] = [await box(page.locator('.page')), await box(field)];
    return Math.min(
      text.x - sheet.x,
      text.y - sheet.y,
      sheet.x + sheet.width - text.x - text.width,
      sheet.y + sheet.height - text.y - text.height,
    );
  };
  // The outline of the field is on the page.
  expect(await room()).toBeGreaterThanOrEqual(2.5);
  const { width } = await box(page.locator('.page'));
  const window = /** @type {{ width: number, height: number }} */ (page.viewportSize());
  await page.setViewportSize({ ...window, height: Math.round(window.height * 0.7) });
  await expect.poll(async () => (await box(page.locator('.page'))).width).toBeLessThan(0.9 * width);
  await expect.poll(room).toBeGreaterThanOrEqual(2.5);
  await page.setViewportSize(window);
});

test('the list of text has the reading order, and text is moved in it by drag, by keys and by a button', async ({
  page,
}) => {
  await openBoard(page);
  for (const text of ['ONE', 'TWO', 'THREE']) await write(page, 'balloon', text);
  await page.keyboard.press('Escape');
  const list = page.getByRole('list', { name: 'Text on the page' });
  const read = () => list.locator('.word-entry span').allInnerTexts();
  // One balloon per panel.
  expect(await read()).toEqual(['ONE', 'TWO', 'THREE']);
  const entry = (/** @type {string} */ name) => list.getByRole('button', { name, exact: true });
  await entry('THREE').focus();
  await page.keyboard.press('Alt+ArrowUp');
  await expect.poll(read).toEqual(['ONE', 'THREE', 'TWO']);
  await expect(entry('THREE')).toBeFocused();
  await idle(page);
  await list.getByRole('button', { name: 'Read earlier' }).click();
  await expect.poll(read).toEqual(['THREE', 'ONE', 'TWO']);
  await entry('THREE').click();
  await accessible(page);
  const [from, to] = [await box(entry('TWO')), await box(entry('THREE'))];
  await page.mouse.move(from.x + 40, from.y + from.height / 2);
  await page.mouse.down();
  await page.mouse.move(from.x + 40, from.y, { steps: 3 });
  await page.mouse.move(to.x + 40, to.y + 3, { steps: 5 });
  await page.mouse.up();
  await expect.poll(read).toEqual(['TWO', 'THREE', 'ONE']);
  await idle(page);
  for (let i = 0; i < 3; i += 1) await press(page, 'Undo');
  await expect.poll(read).toEqual(['ONE', 'TWO', 'THREE']);
});

test('a balloon is dragged, and its tail is dragged to a speaker', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'DRAG ME');
  const balloon = word(page, /^Balloon: DRAG ME/);
  const before = await box(balloon);
  const [x, y] = [before.x + before.width / 2, before.y + before.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 30, y + 40);
  await page.mouse.move(x + 60, y + 80);
  await page.mouse.up();
  await idle(page);
  const after = await box(balloon);
  expect(Math.hypot(after.x - before.x - 60, after.y - before.y - 80)).toBeLessThan(4);
  const drawn = await inked(page);
  const tail = word(page, /^Tail of/);
  const held = await box(tail);
  await page.mouse.move(held.x + 12, held.y + 12);
  await page.mouse.down();
  await page.mouse.move(held.x + 92, held.y + 132, { steps: 4 });
  await page.mouse.up();
  await idle(page);
  const pointed = await box(tail);
  expect(Math.hypot(pointed.x - held.x - 80, pointed.y - held.y - 120)).toBeLessThan(4);
  expect((await inked(page)).y).toBeGreaterThan(drawn.y);
  await press(page, 'Undo');
  await press(page, 'Undo');
  const back = await box(balloon);
  expect(Math.hypot(back.x - before.x, back.y - before.y)).toBeLessThan(2);
});

test('keyboard: a balloon is edited, moved and removed, and its tail is moved', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'KEYS');
  const balloon = word(page, /^Balloon: KEYS/);
  await expect(balloon).toBeFocused();
  const before = await box(balloon);
  for (let i = 0; i < 3; i += 1) await page.keyboard.press('Shift+ArrowDown');
  await idle(page);
  expect((await box(balloon)).y - before.y).toBeGreaterThan(15);
  const tail = word(page, /^Tail of/);
  const held = await box(tail);
  await tail.focus();
  await page.keyboard.press('Shift+ArrowRight');
  await idle(page);
  expect((await box(tail)).x - held.x).toBeGreaterThan(5);
  await balloon.focus();
  await page.keyboard.press('Enter');
  await page.keyboard.type('TWO');
  await page.keyboard.press('Shift+Enter');
  await page.keyboard.type('LINES');
  await page.keyboard.press('Enter');
  await idle(page);
  await expect(word(page, /^Balloon: TWO\s+LINES/)).toBeFocused();
  await page.keyboard.press('Enter');
  await page.keyboard.type('ANOTHER');
  await page.keyboard.press('Escape');
  await expect(word(page, 'Balloon: ANOTHER')).toBeFocused();
  await page.keyboard.press('Control+z');
  await word(page, /^Balloon: TWO\s+LINES/).focus();
  await page.keyboard.press('Delete');
  await expect(word(page, /: /)).toHaveCount(0);
  expect((await inked(page)).count).toBe(0);
  await page.keyboard.press('Control+z');
  await expect(word(page, /^Balloon: TWO/)).toBeVisible();
});

test('text is written in its balloon, and is at least 10 pixels high', async ({ page }) => {
  await openBoard(page);
  await page.setViewportSize({ width: 1440, height: 900 });
  await write(page, 'balloon', 'Where have you been?');
  const canvas = await box(page.locator('.page-canvas'));
  const points = Number(await page.getByRole('spinbutton', { name: 'Text size' }).inputValue());
  expect((points / 72 / (2480 / 300)) * canvas.width).toBeGreaterThanOrEqual(10);
  const balloon = await box(word(page, /^Balloon: /));
  const fill = await drawnFill(page);
  await word(page, /^Balloon: /).press('Enter');
  const field = page.getByRole('textbox', { name: /^Text of/ });
  const look = await field.evaluate((area) => {
    const { backgroundColor, textTransform, borderTopLeftRadius } = getComputedStyle(area);
    return [backgroundColor, textTransform, borderTopLeftRadius];
  });
  expect(look).toEqual([fill, 'uppercase', '42%']);
  const editor = await box(field);
  const middle = (/** @type {typeof editor} */ area) => [area.x + area.width / 2, area.y + area.height / 2];
  const [[x, y], [u, v]] = [middle(balloon), middle(editor)];
  expect(Math.hypot(x - u, y - v)).toBeLessThan(8);
  // The text has the font and the size of the page, so the field is as large as the balloon.
  await expect.poll(() => page.evaluate(() => document.fonts.size)).toBeGreaterThan(0);
  await expect
    .poll(async () => {
      const { width, height } = await box(field);
      return Math.max(Math.abs(width - balloon.width), Math.abs(height - balloon.height));
    })
    .toBeLessThan(2);
  // A long word stays in one line, whatever font the system has.
  await field.fill('Hippopotamuses!');
  await expect(page.getByRole('list', { name: 'Text on the page' })).toContainText('Hippopotamuses!');
  expect(await field.evaluate((area) => area.scrollWidth - area.clientWidth)).toBe(0);
  expect(await field.evaluate((area) => getComputedStyle(area).overflowWrap)).toBe('normal');
  // A text that needs no other size leaves the balloon in its place.
  await field.fill('Where were you then?');
  await page.keyboard.press('Enter');
  await expect(word(page, /^Balloon: Where were you then/)).toBeVisible();
  const { x: left, y: top, width } = await box(word(page, /^Balloon: /));
  if (Math.abs(width - balloon.width) < 0.5) expect([left, top]).toEqual([balloon.x, balloon.y]);
  await word(page, /^Balloon: /).press('Enter');
  await field.fill('Where have you been?');
  await page.keyboard.press('Escape');
  await tab(page, 'Page');
  await page.getByRole('radio', { name: 'For print' }).check();
  await idle(page);
  await tab(page, 'Text');
  await expect
    .poll(async () => Number(await page.getByRole('spinbutton', { name: 'Text size' }).inputValue()))
    .toBeCloseTo(10, 0);
});

test('a balloon grows where it is while its text becomes longer', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'Wait');
  let before = await box(word(page, /^Balloon: /));
  for (const text of ['Wait for', 'Wait for me at', 'Wait for me at the old']) {
    await word(page, /^Balloon: /).press('Enter');
    await page.getByRole('textbox', { name: /^Text of/ }).fill(text);
    await page.keyboard.press('Enter');
    await expect(word(page, `Balloon: ${text}`)).toBeVisible();
    const after = await box(word(page, `Balloon: ${text}`));
    const across = Math.min(before.x + before.width, after.x + after.width) - Math.max(before.x, after.x);
    const down = Math.min(before.y + before.height, after.y + after.height) - Math.max(before.y, after.y);
    // Another line break makes it narrower.
    expect((across * down) / (before.width * before.height)).toBeGreaterThan(0.75);
    expect(after.width * after.height).toBeGreaterThanOrEqual(0.99 * before.width * before.height);
    before = after;
  }
});

test('a long text does not push the fields of its text item out of the panel', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'a very long line that nobody would ever say at once but in a comic '.repeat(6));
  const side = await box(page.getByRole('region', { name: 'Text', exact: true }));
  for (const name of ['X', 'Y', 'Width', 'Text size']) {
    const field = page.getByRole('spinbutton', { name, exact: true });
    await field.scrollIntoViewIfNeeded();
    const { x, width } = await box(field);
    expect(x).toBeGreaterThanOrEqual(side.x);
    expect(x + width).toBeLessThanOrEqual(side.x + side.width);
  }
});

test('a balloon is also moved by a click and by a field, and has four shapes', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'CLICK');
  const canvas = await box(page.locator('.page-canvas'));
  const spot = { x: canvas.x + canvas.width * 0.7, y: canvas.y + canvas.height * 0.8 };
  await press(page, 'Move to…');
  await page.mouse.click(spot.x, spot.y);
  await idle(page);
  const moved = await box(word(page, /^Balloon: CLICK/));
  expect(Math.hypot(moved.x + moved.width / 2 - spot.x, moved.y + moved.height / 2 - spot.y)).toBeLessThan(4);
  await page.getByRole('button', { name: 'Point tail at…' }).click();
  await page.mouse.click(spot.x - 120, spot.y - 160);
  await idle(page);
  const tail = await box(word(page, /^Tail of/));
  expect(Math.hypot(tail.x + 12 - spot.x + 120, tail.y + 12 - spot.y + 160)).toBeLessThan(4);
  await page.getByRole('spinbutton', { name: 'X', exact: true }).fill('63');
  await page.keyboard.press('Tab');
  await idle(page);
  const across = await box(word(page, /^Balloon: CLICK/));
  expect(Math.abs(across.x + across.width / 2 - canvas.x - canvas.width * 0.3)).toBeLessThan(4);
  const pictures = new Set();
  for (const shape of ['Speech', 'Thought', 'Shout', 'Whisper']) {
    await page.getByRole('combobox', { name: 'Shape' }).selectOption({ label: shape });
    await idle(page);
    pictures.add((await inked(page)).count);
  }
  expect(pictures.size).toBe(4);
  await press(page, 'Remove tail');
  await expect(word(page, /^Tail of/)).toHaveCount(0);
  await page.getByRole('button', { name: 'Remove text' }).click();
  await expect(word(page, /: /)).toHaveCount(0);
});

test('text items remain after Shuffle and on alternatives, and are in the PNG file at the same place', async ({
  page,
}) => {
  await openBoard(page);
  await makePageSmall(page);
  // In a gray style no photo contains the yellow of the caption.
  await tab(page, 'Styles');
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'Noir', exact: true }).click();
  await page.getByRole('button', { name: 'Lock style' }).click();
  await write(page, 'caption', 'ONCE UPON A TIME');
  // By default a caption has the colours of the style.
  await page.getByLabel('Fill', { exact: true }).fill('#fff6d6');
  await idle(page);
  await press(page, 'Shuffle');
  await expect(word(page, 'Caption: ONCE UPON A TIME')).toBeVisible();
  const at = await inked(page);
  expect(at.count).toBeGreaterThan(200);
  const png = PNG.sync.read((await download(page)).bytes);
  // The yellow of the caption is at the same place as in the preview.
  /** @type {number[][]} */
  const pixels = [];
  for (let i = 0; i < png.width * png.height; i += 1) {
    const [r, g, b] = [png.data[i * 4], png.data[i * 4 + 1], png.data[i * 4 + 2]];
    if (r === 0xff && g === 0xf6 && b === 0xd6)
      pixels.push([(i % png.width) / png.width, Math.floor(i / png.width) / png.height]);
  }
  expect(pixels.length).toBeGreaterThan(2000 * (600 / 2480) ** 2);
  const mean = (/** @type {number} */ k) => pixels.reduce((sum, place) => sum + place[k], 0) / pixels.length;
  expect(Math.hypot(mean(0) - at.x, mean(1) - at.y)).toBeLessThan(0.03);
  await page.getByRole('button', { name: 'Show suggestions' }).click();
  await press(page, 'Suggestion 2');
  await expect(word(page, 'Caption: ONCE UPON A TIME')).toBeVisible();
});

test('a script becomes balloons in one undo step, and a text item is resized, rotated and curved', async ({ page }) => {
  await openBoard(page);
  await tab(page, 'Text');
  await page
    .getByRole('textbox', { name: 'Script or dialogue' })
    .fill('ANNA: Where are we?\nBEN (thinks): Что это? Πού; 你好\n\nSFX: Splash');
  await page.getByRole('button', { name: 'Create balloons' }).click();
  await expect(word(page, /: /)).toHaveCount(3);
  await idle(page);
  const effect = word(page, 'Sound effect: SPLASH');
  await effect.click();
  const bar = page.getByRole('toolbar', { name: 'Lettering tools' });
  // The bar is next to the page.
  const [before, tools, canvas] = [await box(effect), await box(bar), await box(page.locator('.page-canvas'))];
  expect(tools.x).toBeGreaterThanOrEqual(canvas.x + canvas.width);
  const dragHandle = async (/** @type {string} */ name, /** @type {number} */ x, /** @type {number} */ y) => {
    const handle = await box(page.getByRole('button', { name, exact: true }));
    await drag(page, [handle.x + 12, handle.y + 12], [handle.x + 12 + x, handle.y + 12 + y]);
  };
  await dragHandle('Resize text', 40, 20);
  expect((await box(effect)).width).toBeGreaterThan(before.width * 1.1);
  await dragHandle('Rotate text', 60, 30);
  const angle = page.getByRole('spinbutton', { name: 'Angle' });
  expect(Number(await angle.inputValue())).toBeGreaterThan(0);
  await page.getByRole('spinbutton', { name: 'Arc', exact: true }).fill('60');
  await bar.getByRole('button', { name: 'Larger text' }).click();
  await idle(page);
  await accessible(page);
  for (let i = 0; i < 5; i += 1) await press(page, 'Undo');
  await expect(word(page, /: /)).toHaveCount(0);
});

/** @param {string} name @param {string} text */
const textFile = (name, text) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });

test('subtitles of a whole film are spread over the panels of photos, and the rest is unplaced', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 4));
  const time = (/** @type {number} */ second) => new Date(second * 1000).toISOString().slice(11, 19);
  const cues = Array.from({ length: 1332 }, (_, i) => `${time(i * 4)},000 --> ${time(i * 4 + 2)},000\nLine ${i}\n`);
  await drop(page, [textFile('film.srt', cues.join('\n'))]);
  const message = page.getByRole('status').filter({ hasText: '1,332' });
  await expect(message).toContainText(/^\D*([\d,]+) of 1,332 lines were placed; [\d,]+ did not fit/);
  await idle(page);
  const panels = page.getByRole('region', { name: 'Comic page' }).getByRole('group', { name: /^Panel \d/ });
  const most = 3 * (await panels.count());
  await expect(word(page, /^Balloon: Line/)).toHaveCount(most);
  await expect(word(page, 'Balloon: Line 0')).toBeVisible();
  await expect(word(page, 'Balloon: Line 333')).toBeVisible();
  await tab(page, 'Text');
  await expect(page.getByText(`${(1332 - most).toLocaleString('en')} unplaced texts`)).toBeVisible();
  await press(page, 'Undo');
  await expect(word(page, /^Balloon: Line/)).toHaveCount(0);
});

test('a guessed encoding is reported until the message is closed, and can be changed', async ({ page }) => {
  await openBoard(page, SIX.slice(0, 2));
  // `'Привет, мир! Как дела?'.encode('cp1251')` in Python.
  const said = Buffer.from('cff0e8e2e5f22c20ece8f02120cae0ea20e4e5ebe03f', 'hex');
  const buffer = Buffer.concat([Buffer.from('1\r\n00:00:01,000 --> 00:00:02,000\r\n'), said]);
  await drop(page, [{ name: 'film.srt', mimeType: 'text/plain', buffer }]);
  await expect(word(page, 'Balloon: Привет, мир! Как дела?')).toBeVisible();
  await expect(page.getByRole('alert').filter({ hasText: 'film.srt' })).toContainText('Windows-1251');
  await page.getByRole('button', { name: 'Change encoding' }).click();
  const dialog = page.getByRole('dialog', { name: 'Encoding of film.srt' });
  const preview = dialog.getByRole('textbox', { name: 'Preview' });
  await expect(preview).toHaveValue(/Привет, мир!/);
  await accessible(page);
  await dialog.getByRole('combobox', { name: 'Encoding' }).selectOption('IBM866');
  await expect(preview).toHaveValue(/╧ЁштхЄ/);
  await dialog.getByRole('button', { name: 'Read again' }).click();
  await expect(word(page, /^Balloon: ╧ЁштхЄ/)).toBeVisible();
  await expect(word(page, /^Balloon/)).toHaveCount(1);
  await expect(page.getByRole('alert').filter({ hasText: 'film.srt' })).toContainText('IBM866');
});

test('subtitles of a video become balloons on its frames, and a malformed file is reported with the line', async ({
  page,
}) => {
  await openStart(page);
  const film = { name: 'album.mp4', mimeType: 'video/mp4', buffer: await readFile(VIDEO) };
  const cues = Array.from({ length: 6 }, (_, i) => `${i + 1}\n00:00:0${i},050 --> 00:00:0${i},950\nSecond ${i}\n`);
  await add(page, [film, textFile('album.srt', cues.join('\n'))]);
  await expect(word(page, /^Balloon: Second \d/).first()).toBeVisible({ timeout: 60_000 });
  await idle(page);
  const placed = (
    /** @type {ReturnType<import('../../../../www/testing.ts').Page['locator']>} */ things,
    /** @type {string} */ about,
  ) =>
    things.evaluateAll(
      (list, attribute) =>
        list.map((one) => {
          const { x, y, width, height } = one.getBoundingClientRect();
          return { text: one.getAttribute(attribute) ?? '', x, y, right: x + width, bottom: y + height };
        }),
      about,
    );
  const said = await placed(word(page, /^Balloon: Second \d/), 'aria-label');
  const panels = await placed(
    page.getByRole('region', { name: 'Comic page' }).getByRole('group', { name: /^Panel \d/ }),
    'aria-description',
  );
  expect(said.length).toBeGreaterThan(1);
  const span = (/** @type {number[]} */ [a, b, c, d]) => Math.max(0, Math.min(b, d) - Math.max(a, c));
  for (const balloon of said) {
    const shared = panels.map(
      (panel) =>
        span([panel.x, panel.right, balloon.x, balloon.right]) *
        span([panel.y, panel.bottom, balloon.y, balloon.bottom]),
    );
    const middle = Number(/\d/.exec(balloon.text)?.[0]) + 0.5;
    const off = panels.map(({ text }) => Math.abs(Number(/\d+:([\d.]+)/.exec(text)?.[1]) - middle));
    // A subtitle is put on the nearest frame. A frame takes three, so it may be on the next one.
    const [nearest, after = nearest] = [...off].sort((one, other) => one - other);
    expect(off[shared.indexOf(Math.max(...shared))], balloon.text).toBeLessThanOrEqual(after);
  }
  await drop(page, [textFile('bad.srt', '1\n00:00:01 to 00:00:02\nHi')]);
  await expect(page.getByRole('alert')).toContainText('bad.srt: line 1');
});

test('characters that no font contains are reported', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'GO \u{e123}');
  const note = page.getByRole('note').filter({ hasText: 'No font has these characters' });
  await expect(note).toContainText('U+E123');
  expect((await inked(page)).count).toBeGreaterThan(100);
});

test('vertical text is higher than wide, and Undo restores horizontal text', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', '夜の灯台を見ただろうか');
  const lines = await box(word(page, /^Balloon: 夜/));
  const columns = page.getByRole('checkbox', { name: 'Vertical text' });
  await columns.check();
  await idle(page);
  await expect(columns).toBeChecked();
  const high = await box(word(page, /^Balloon: 夜/));
  expect(high.height).toBeGreaterThan(high.width + 4);
  expect(lines.height).toBeLessThan(high.height);
  await accessible(page);
  await press(page, 'Undo');
  await expect(columns).not.toBeChecked();
  const again = await box(word(page, /^Balloon: 夜/));
  expect(Math.abs(again.width - lines.width)).toBeLessThan(1);
});

test('a balloon is joined to the previous balloon and separated again, each as one undo step', async ({ page }) => {
  await openBoard(page);
  const panel = page.getByRole('group', { name: /^Panel 1 of/ });
  const choose = async () => {
    if (!/selected/.test((await panel.getAttribute('aria-description')) ?? ''))
      await panel.click({ position: { x: 20, y: 20 } });
    await expect(panel).toHaveAttribute('aria-description', /selected/);
  };
  await choose();
  await write(page, 'balloon', 'FIRST');
  // The first balloon has no previous balloon.
  const join = page.getByRole('checkbox', { name: 'Link to the previous balloon' });
  await expect(join).toHaveCount(0);
  await choose();
  await write(page, 'balloon', 'SECOND');
  const tails = word(page, /^Tail of/);
  await expect(join).not.toBeChecked();
  await expect(tails).toHaveCount(1);
  await join.check();
  await idle(page);
  // The second balloon has no tail and touches the first.
  await expect(tails).toHaveCount(0);
  const [first, second] = [await box(word(page, /: FIRST/)), await box(word(page, /: SECOND/))];
  const across = Math.max(second.x - first.x - first.width, first.x - second.x - second.width, 0);
  const down = Math.max(second.y - first.y - first.height, first.y - second.y - second.height, 0);
  expect(Math.hypot(across, down)).toBeLessThan(12);
  await press(page, 'Undo');
  await expect(join).not.toBeChecked();
  await press(page, 'Redo');
  await expect(join).toBeChecked();
  await join.uncheck();
  await idle(page);
  await expect(tails).toHaveCount(1);
  await expect(join).not.toBeChecked();
});
