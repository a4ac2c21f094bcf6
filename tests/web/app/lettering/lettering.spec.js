// @ts-check
import { accessible, idle, openBoard, press, expect, test } from '../support.js';
import { box, inked, word, write } from '../word-hands.js';

test('words are added, written and drawn, one undo a step', async ({ page }) => {
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
  // Six steps: each was added, then written.
  for (let i = 0; i < 6; i += 1) await press(page, 'Undo');
  await expect(word(page, /: /)).toHaveCount(0);
  await press(page, 'Redo');
  await expect(word(page, 'Balloon: Hello!')).toBeVisible();
});

test('a word is dragged, and its tail is dragged to a speaker', async ({ page }) => {
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

test('the keyboard alone writes, moves, points and removes', async ({ page }) => {
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
  await page.keyboard.type('not this');
  await page.keyboard.press('Escape');
  await expect(word(page, /^Balloon: TWO\s+LINES/)).toBeFocused();
  await page.keyboard.press('Delete');
  await expect(word(page, /: /)).toHaveCount(0);
  expect((await inked(page)).count).toBe(0);
  await page.keyboard.press('Control+z');
  await expect(word(page, /^Balloon: TWO/)).toBeVisible();
});

test('a long text leaves the fields of its word in sight', async ({ page }) => {
  await openBoard(page);
  await write(page, 'balloon', 'a very long line that nobody would ever say at once but in a comic '.repeat(6));
  const side = await box(page.getByRole('region', { name: 'Words', exact: true }));
  for (const name of ['Across', 'Down', 'Width', 'Letter size']) {
    const field = page.getByRole('spinbutton', { name, exact: true });
    await field.scrollIntoViewIfNeeded();
    const { x, width } = await box(field);
    expect(x).toBeGreaterThanOrEqual(side.x);
    expect(x + width).toBeLessThanOrEqual(side.x + side.width);
  }
});
