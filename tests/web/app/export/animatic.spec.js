// @ts-check
/** Animatics: played in the app, and saved as MP4, WebM and GIF files that ffprobe reads. */

import { chooseFormat, openExport, saved } from '../export-dialog.js';
import { probed } from '../video-files.js';
import { accessible, expect, idle, openBoard, sharedBoardTest as test } from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** Frames of the animatic: three shots of half a second at 24 frames per second. */
const FRAMES = 36;

/** @param {Page} page */
async function openAnimatic(page) {
  const dialog = await openExport(page);
  await chooseFormat(dialog, 'animatic');
  await expect(dialog.getByRole('group', { name: 'Animatic' })).toBeVisible();
  await dialog.getByRole('slider', { name: 'Seconds per shot' }).fill('0.5');
  await expect(dialog.getByText('3 shots, 0:01 at 24 frames per second')).toBeVisible();
  return dialog;
}

/** @param {any} probe @param {string} type */
const stream = (probe, type) =>
  probe.streams.find((/** @type {any} */ { codec_type: kind }) => kind === type) ?? expect(type).toBe('in the file');

/** Half a second of a tone as a WAV file of 16 bits. */
function tone() {
  const rate = 8000;
  const samples = Buffer.alloc(rate);
  for (let i = 0; i < rate / 2; i += 1) samples.writeInt16LE(Math.round(8000 * Math.sin(i / 3)), 2 * i);
  const head = Buffer.alloc(44);
  head.write('RIFF', 0);
  head.writeUInt32LE(36 + samples.length, 4);
  head.write('WAVEfmt ', 8);
  head.writeUInt32LE(16, 16);
  head.writeUInt16LE(1, 20);
  head.writeUInt16LE(1, 22);
  head.writeUInt32LE(rate, 24);
  head.writeUInt32LE(2 * rate, 28);
  head.writeUInt16LE(2, 32);
  head.writeUInt16LE(16, 34);
  head.write('data', 36);
  head.writeUInt32LE(samples.length, 40);
  return { name: 'tone.wav', mimeType: 'audio/wav', buffer: Buffer.concat([head, samples]) };
}

test.beforeEach(({ page }) => openBoard(page, ['bee.jpg', 'cat.jpg', 'gateway.jpg']));

for (const [kind, container, codec] of [
  ['mp4', 'mov,mp4,m4a,3gp,3g2,mj2', 'h264'],
  ['webm', 'matroska,webm', 'vp9'],
])
  test(`an animatic is saved as ${kind}, with the exact number of frames and sound`, { tag: '@ci' }, async ({
    page,
  }) => {
    const dialog = await openAnimatic(page);
    await dialog.getByRole('combobox', { name: 'File' }).selectOption(kind);
    await dialog.getByRole('combobox', { name: 'Size' }).selectOption('720p');
    await dialog.getByRole('combobox', { name: 'Transition' }).selectOption({ label: 'Dissolves' });
    await dialog.getByLabel('Soundtrack').setInputFiles(tone());
    await expect(dialog.getByText('tone.wav', { exact: true })).toBeVisible();
    const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
    expect(file.name).toMatch(new RegExp(`\\.${kind}$`));
    const probe = await probed(file.path);
    expect(probe.complaints).toBe('');
    expect(probe.format.format_name).toBe(container);
    expect(stream(probe, 'video')).toMatchObject({
      codec_name: codec,
      width: 1280,
      height: 720,
      nb_read_frames: String(FRAMES),
      r_frame_rate: '24/1',
    });
    expect(Number(probe.format.duration)).toBeCloseTo(FRAMES / 24, 1);
    expect(stream(probe, 'audio').codec_name).toMatch(/aac|opus/);
    await expect(page.getByText(`${file.name} was saved.`)).toBeVisible();
  });

test('an animatic of a board at 23.976 frames per second has this rate', { tag: '@ci' }, async ({ page }) => {
  await page.getByRole('button', { name: 'Storyboard', exact: true }).click();
  await page.getByRole('combobox', { name: 'Frames per second' }).selectOption('23.976');
  await page.getByRole('button', { name: 'Animatic', exact: true }).click();
  const dialog = page.getByRole('dialog', { name: 'Export' });
  await dialog.getByRole('slider', { name: 'Seconds per shot' }).fill('0.5');
  await expect(dialog.getByText('3 shots, 0:01 at 23.976 frames per second')).toBeVisible();
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  const probe = await probed(file.path);
  expect(probe.complaints).toBe('');
  expect(stream(probe, 'video')).toMatchObject({ nb_read_frames: String(FRAMES), r_frame_rate: '24000/1001' });
});

test('an animatic is saved as GIF, with the same duration, smaller and without sound', async ({ page }) => {
  const dialog = await openAnimatic(page);
  await dialog.getByRole('combobox', { name: 'File' }).selectOption('gif');
  await expect(dialog.getByText('3 shots, 0:01 at 12 frames per second')).toBeVisible();
  await expect(dialog.getByRole('button', { name: 'Soundtrack' })).toBeDisabled();
  await dialog.getByRole('checkbox', { name: 'Camera moves' }).uncheck();
  const file = await saved(page, () => dialog.getByRole('button', { name: 'Download' }).click());
  const probe = await probed(file.path);
  // Without camera moves, each shot is one frame.
  expect(stream(probe, 'video')).toMatchObject({ codec_name: 'gif', width: 640, height: 360, nb_read_frames: '3' });
  expect(Number(probe.format.duration)).toBeCloseTo(1.5, 1);
});

test('keyboard: an animatic plays, stops, and moves to a position', async ({ page }) => {
  const dialog = await openAnimatic(page);
  const screen = dialog.getByRole('group', { name: 'Animatic' }).getByRole('img');
  const frame = async () => Number(await screen.getAttribute('data-frame'));
  const seen = () =>
    screen.evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL('image/webp', 0.5));
  const position = dialog.getByRole('slider', { name: 'Position' });
  await expect(position).toHaveAttribute('aria-valuetext', '0:00 of 0:01, shot 1');
  await expect.poll(async () => (await seen()).length).toBeGreaterThan(1500);
  await dialog.getByRole('button', { name: 'Play' }).press('Enter');
  await expect(dialog.getByRole('button', { name: 'Play' })).toBeVisible();
  expect(await frame()).toBe(FRAMES - 1);
  await expect(position).toHaveAttribute('aria-valuetext', '0:01 of 0:01, shot 3');
  const last = await seen();
  await position.focus();
  await page.keyboard.press('Home');
  expect(await frame()).toBe(0);
  await expect.poll(seen).not.toBe(last);
  await page.keyboard.press('ArrowRight');
  expect(await frame()).toBe(1);
  await page.keyboard.press('Space');
  await expect(dialog.getByRole('button', { name: 'Pause' })).toBeVisible();
  await page.keyboard.press('Space');
  await expect(dialog.getByRole('button', { name: 'Play' })).toBeVisible();
});

test('an animatic opened from the board has its lengths, and its export can be cancelled', async ({ page }) => {
  await page.getByRole('button', { name: 'Storyboard', exact: true }).click();
  const shots = page.getByRole('region', { name: 'Shots' });
  await shots.getByRole('textbox', { name: 'Length, shot 1' }).fill('90');
  await page.keyboard.press('Enter');
  await page.getByRole('button', { name: 'Animatic', exact: true }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByText('3 shots, 1:34 at 24 frames per second')).toBeVisible();
  await accessible(page);
  // A GIF file is limited to a minute.
  await dialog.getByRole('combobox', { name: 'File' }).selectOption('gif');
  await expect(dialog.getByText('a GIF file can be at most one minute long')).toBeVisible();
  await expect(dialog.getByRole('button', { name: 'Download' })).toBeDisabled();
  await dialog.getByRole('combobox', { name: 'File' }).selectOption('mp4');
  await dialog.getByRole('button', { name: 'Download' }).click();
  await expect(page.getByRole('progressbar', { name: /^Creating the animatic/ })).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByRole('progressbar', { name: /^Creating the animatic/ })).toHaveCount(0);
  await idle(page);
});

test('an unreadable sound file is reported', async ({ page }) => {
  const dialog = await openAnimatic(page);
  await dialog.getByLabel('Soundtrack').setInputFiles({
    name: 'noise.mp3',
    mimeType: 'audio/mpeg',
    buffer: Buffer.from('no sound'),
  });
  await dialog.getByRole('button', { name: 'Download' }).click();
  await expect(page.getByRole('alert')).toContainText('the browser cannot read the sound');
});

for (const [width, height] of [
  [1280, 800],
  [360, 740],
])
  test(`axe finds nothing in the dialog of an animatic, ${width} pixels wide`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    const dialog = width > 1000 ? await openAnimatic(page) : await openExport(page);
    if (width < 1000) await chooseFormat(dialog, 'animatic');
    await expect(dialog.getByRole('button', { name: 'Play' })).toBeEnabled();
    await accessible(page);
    const save = dialog.getByRole('button', { name: 'Download' });
    await save.scrollIntoViewIfNeeded();
    await save.click({ trial: true });
  });
