// @ts-check
import { readFile } from 'node:fs/promises';
import { PNG } from '../../../../www/testing.ts';
import { accessible, add, drop, expect, idle, openBoard, press, tab, test } from '../support.js';
import { box, inked, word, write } from '../word-hands.js';

const VIDEO = new URL('../../../videos/album.mp4', import.meta.url);

test('every drag has a click and a field', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'CLICK');
  const canvas = await box(page.locator('.page-canvas'));
  const spot = { x: canvas.x + canvas.width * 0.7, y: canvas.y + canvas.height * 0.8 };
  await page.getByRole('button', { name: 'Move to…' }).click();
  await page.mouse.click(spot.x, spot.y);
  await idle(page);
  const moved = await box(word(page, /^Balloon: CLICK/));
  expect(Math.hypot(moved.x + moved.width / 2 - spot.x, moved.y + moved.height / 2 - spot.y)).toBeLessThan(4);
  await page.getByRole('button', { name: 'Point tail at…' }).click();
  await page.mouse.click(spot.x - 120, spot.y - 160);
  await idle(page);
  const tail = await box(word(page, /^Tail of/));
  expect(Math.hypot(tail.x + 12 - spot.x + 120, tail.y + 12 - spot.y + 160)).toBeLessThan(4);
  await page.getByRole('spinbutton', { name: 'Across' }).fill('30');
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
  await page.getByRole('button', { name: 'Remove tail' }).click();
  await expect(word(page, /^Tail of/)).toHaveCount(0);
  await page.getByRole('button', { name: 'Remove word' }).click();
  await expect(word(page, /: /)).toHaveCount(0);
});

test('words stay through shuffles, are on the alternatives and in the PNG', async ({ page }) => {
  await openBoard(page);
  // A style in gray: no photo has the yellow that the caption gets.
  await tab(page, 'Styles');
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option', { name: 'Noir', exact: true }).click();
  await page.getByRole('button', { name: 'Lock style' }).click();
  await write(page, 'caption', 'ONCE UPON A TIME');
  // A colour that nothing else on the page has: of itself a caption has the inks of the style.
  await page.getByLabel('Fill', { exact: true }).fill('#fff6d6');
  await idle(page);
  await press(page, 'Shuffle');
  await expect(word(page, 'Caption: ONCE UPON A TIME')).toBeVisible();
  const at = await inked(page);
  expect(at.count).toBeGreaterThan(200);
  const waiting = page.waitForEvent('download', { timeout: 60_000 });
  await page.getByRole('button', { name: 'Download PNG' }).click();
  const png = PNG.sync.read(await readFile(await (await waiting).path()));
  // The caption's yellow, at the same place as in the preview.
  /** @type {number[][]} */
  const pixels = [];
  for (let i = 0; i < png.width * png.height; i += 1) {
    const [r, g, b] = [png.data[i * 4], png.data[i * 4 + 1], png.data[i * 4 + 2]];
    if (r === 0xff && g === 0xf6 && b === 0xd6)
      pixels.push([(i % png.width) / png.width, Math.floor(i / png.width) / png.height]);
  }
  expect(pixels.length).toBeGreaterThan(2000);
  const mean = (/** @type {number} */ k) => pixels.reduce((sum, place) => sum + place[k], 0) / pixels.length;
  expect(Math.hypot(mean(0) - at.x, mean(1) - at.y)).toBeLessThan(0.03);
  await page.getByRole('button', { name: 'Alternative 2', exact: true }).click();
  await idle(page);
  await expect(word(page, 'Caption: ONCE UPON A TIME')).toBeVisible();
});

test('a script becomes balloons in one step, and a word is made wider, turned and restyled on the page', async ({
  page,
}) => {
  await openBoard(page);
  await tab(page, 'Words');
  await page
    .getByRole('textbox', { name: 'Script or dialogue' })
    .fill('ANNA: Where are we?\nBEN (thinks): Что это? Πού; 你好\n\nSFX: Splash');
  await page.getByRole('button', { name: 'Put into balloons' }).click();
  await expect(word(page, /: /)).toHaveCount(3);
  await idle(page);
  const effect = word(page, 'Sound effect: SPLASH');
  await effect.click();
  const bar = page.getByRole('toolbar', { name: 'Lettering tools' });
  const [before, above] = [await box(effect), await box(bar)];
  expect(above.y + above.height <= before.y || above.y >= before.y + before.height).toBe(true);
  const drag = async (/** @type {string} */ name, /** @type {number} */ x, /** @type {number} */ y) => {
    const handle = await box(page.getByRole('button', { name, exact: true }));
    await page.mouse.move(handle.x + 12, handle.y + 12);
    await page.mouse.down();
    await page.mouse.move(handle.x + 12 + x, handle.y + 12 + y, { steps: 4 });
    await page.mouse.up();
    await idle(page);
  };
  await drag('Resize word', 40, 20);
  expect((await box(effect)).width).toBeGreaterThan(before.width * 1.1);
  await drag('Turn word', 60, 30);
  const angle = page.getByRole('spinbutton', { name: 'Angle' });
  expect(Number(await angle.inputValue())).toBeGreaterThan(0);
  await bar.getByRole('button', { name: 'Arch up' }).click();
  await expect(page.getByRole('spinbutton', { name: 'Arc', exact: true })).toHaveValue('60');
  await accessible(page);
  for (let i = 0; i < 4; i += 1) await press(page, 'Undo');
  await expect(word(page, /: /)).toHaveCount(0);
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 360, height: 740 }, hasTouch: true });

  test('a balloon is added, written and moved by touch', async ({ page }) => {
    await openBoard(page);
    await page.getByRole('button', { name: 'Words', exact: true }).click();
    await accessible(page);
    await page.getByRole('button', { name: 'Add balloon' }).click();
    await expect(page.getByRole('textbox', { name: /^Text of/ })).toBeFocused();
    await page.keyboard.type('SMALL');
    await page.keyboard.press('Enter');
    await idle(page);
    const balloon = word(page, /^Balloon: SMALL/);
    await balloon.tap();
    await expect(balloon).toHaveAttribute('aria-pressed', 'true');
    await accessible(page);
    expect(await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)).toBeLessThanOrEqual(0);
  });
});

/** @param {string} name @param {string} text */
const textFile = (name, text) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });

test('subtitles that come with a video are put on its frames; what is malformed is said with its line', async ({
  page,
}) => {
  await page.goto('./');
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
    page.getByRole('region', { name: 'Storyboard page' }).getByRole('group', { name: /^Panel \d/ }),
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
    // However many frames the page shows, what is said goes to the nearest, or, as a frame takes three, to the one after it.
    const [nearest, after = nearest] = [...off].sort((one, other) => one - other);
    expect(off[shared.indexOf(Math.max(...shared))], balloon.text).toBeLessThanOrEqual(after);
  }
  await drop(page, [textFile('bad.srt', '1\n00:00:01 to 00:00:02\nHi')]);
  await expect(page.getByRole('alert')).toContainText('bad.srt: line 1');
});

test('letters that no font has are named', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'GO \u{e123}');
  const note = page.getByRole('note').filter({ hasText: 'in no font' });
  await expect(note).toContainText('U+E123');
  expect((await inked(page)).count).toBeGreaterThan(100);
});

test('a word stands in columns, higher than it is wide, and comes back by undo', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', '夜の灯台を見ただろうか');
  const lines = await box(word(page, /^Balloon: 夜/));
  const columns = page.getByRole('checkbox', { name: 'In columns, from the top down' });
  await page.getByRole('toolbar', { name: 'Lettering tools' }).getByRole('button', { name: 'In columns' }).click();
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

test('a second balloon is joined to the one before and parted again, each in one step', async ({ page }) => {
  await openBoard(page);
  const panel = page.getByRole('group', { name: /^Panel 1 of/ });
  const choose = async () => {
    if (!/selected/.test((await panel.getAttribute('aria-description')) ?? ''))
      await panel.click({ position: { x: 20, y: 20 } });
    await expect(panel).toHaveAttribute('aria-description', /selected/);
  };
  await choose();
  await write(page, 'balloon', 'FIRST');
  // The first has nothing to hang on.
  const join = page.getByRole('checkbox', { name: 'Join to the balloon before' });
  await expect(join).toHaveCount(0);
  await choose();
  await write(page, 'balloon', 'SECOND');
  const tails = word(page, /^Tail of/);
  await expect(join).not.toBeChecked();
  await expect(tails).toHaveCount(1);
  await join.check();
  await idle(page);
  // The tail is that of the first: this one has none, and stands beside it.
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
