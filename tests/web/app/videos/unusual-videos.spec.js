// @ts-check
/** Videos that are damaged, that browsers cannot decode, or that have a wrong file name. */

import { readFile } from 'node:fs/promises';
import { add, dismissAlerts, expect, idle, openStart, photos, sharedBoardTest as test } from '../support.js';

const ODD = new URL('../../../videos/odd/', import.meta.url);

/** @param {string} name @param {string} [as] */
async function video(name, as = name) {
  return { name: as, mimeType: 'video/mp4', buffer: await readFile(new URL(name, ODD)) };
}

/** Videos without a readable frame, and the reason that is reported. @type {[string, RegExp][]} */
const UNREADABLE = [
  ['hevc.mp4', /HEVC \(H\.265\).*Convert it to MP4 with H\.264/],
  ['prores.mov', /ProRes.*Convert it/],
  ['part2.avi', /AVI, MPEG-4 Part 2.*Convert it/],
  ['part2.mp4', /MPEG-4 Part 2.*Convert it/],
  ['theora.ogv', /Theora.*Convert it/],
  ['sound.mp4', /only sound/],
];

test('an unreadable video is reported once with the reason, also among other unreadable videos', async ({ page }) => {
  await openStart(page);
  const alert = page.getByRole('alert');
  const used = page.getByRole('checkbox', { name: /^Use / });
  await add(page, [await video('headless.mp4')]);
  await expect(alert.getByText(/file is incomplete/)).toBeVisible();
  await expect(alert.getByText(/None of these files/)).toHaveCount(0);
  await expect(used).toHaveCount(0);
  await dismissAlerts(page);

  const empty = { name: 'empty.mp4', mimeType: 'video/mp4', buffer: Buffer.alloc(0) };
  await add(page, [...(await Promise.all(UNREADABLE.map(([name]) => video(name)))), empty]);
  await alert.getByRole('button', { name: 'Show the list' }).click();
  const list = page.getByRole('dialog').getByRole('listitem');
  await expect(list).toHaveCount(UNREADABLE.length + 1);
  for (const [name, why] of [
    ...UNREADABLE,
    /** @type {[string, RegExp]} */ (['empty.mp4', /the video has no frames/]),
  ]) {
    const reported = list.filter({ hasText: new RegExp(`^${name}`) });
    await expect(reported).toHaveCount(1);
    await expect(reported).toHaveText(why);
  }
  await page.keyboard.press('Escape');
  await expect(used).toHaveCount(0);
});

test('truncated and unusual videos have their frames, and the content of a file counts, not its name', async ({
  page,
}) => {
  await openStart(page);
  const alert = page.getByRole('alert');
  const [bee] = await photos('bee.jpg');
  await add(page, [
    { ...(await video('variable.mp4', 'holiday.jpg')), mimeType: 'image/jpeg' },
    await video('hdr.webm'),
    await video('half.mp4'),
    { ...bee, name: 'bee.mp4', mimeType: 'video/mp4' },
  ]);
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
  await expect(alert.getByText(/it ends at 0:0[01]\.\d of 0:03/)).toBeVisible();
  await idle(page);
  const frames = (/** @type {RegExp} */ name) => page.getByRole('checkbox', { name });
  await expect(frames(/^Use holiday\.jpg, 0:0/)).toHaveCount(8);
  await expect(frames(/^Use hdr\.webm/)).toHaveCount(8);
  expect(await frames(/^Use half\.mp4/).count()).toBeGreaterThanOrEqual(6);
  await expect(page.getByRole('checkbox', { name: 'Use bee.mp4' })).toBeChecked();
  await dismissAlerts(page);

  await add(page, [await video('half.webm'), await video('variable.mp4')]);
  await expect(alert.getByText(/it ends at 0:\d+\.\d of 0:38/)).toBeVisible();
  await idle(page);
  expect(await frames(/^Use half\.webm/).count()).toBeGreaterThanOrEqual(6);
  await expect(frames(/^Use variable\.mp4/)).toHaveCount(8);
});
