// @ts-check
/** Project files that cannot be opened change nothing, and stored text can be read again. */

import { soundPage, soundProject } from '../malformed-files.js';
import { SMALL, expectSaved, goodFiles } from '../project-files.js';
import { accessible, add, contents, drop, expect, idle, picture, press, tab, test } from '../support.js';
import { tables } from '../database.js';
import { word, write } from '../text-items.js';

/** @typedef {import('../support.js').Page} Page */

const idOf = (/** @type {Page} */ page) => page.evaluate(() => String(sessionStorage.getItem('inkpanel.project')));

/** Opens and saves a project with a thumbnail. @param {Page} page */
async function first(page) {
  await page.goto('./');
  await add(page, SMALL);
  await idle(page);
  await page.getByLabel('Project name').fill('First');
  await page.keyboard.press('Enter');
  await press(page, 'Shuffle');
  await expectSaved(page);
  const id = await idOf(page);
  await expect
    .poll(async () => (await tables(page, { of: id })).projects[id].picture, { timeout: 30_000 })
    .toContain('blob');
  return id;
}

/** @param {Page} page */
async function all(page) {
  return {
    tables: await tables(page),
    contents: await contents(page),
    picture: await picture(page),
    undo: await page.getByRole('button', { name: 'Undo' }).isEnabled(),
  };
}

/** @type {Record<string, (document: any) => void>} */
const REFUSED = {
  'words of nothing': ({ history }) => {
    history.present.page.words = [null];
  },
  'photos alike by halves': ({ history }) => {
    history.present.alike = 10.5;
  },
  'settings without a width': ({ history }) => {
    history.present.settings.width = null;
  },
  'a merge of nothing': ({ history }) => {
    history.present.page.merges = [null];
  },
  'a number for a text': ({ history }) => {
    history.present.page.words = [{ kind: 'caption', text: 5, panel: 0 }];
  },
  'a thousand words': ({ history }) => {
    history.present.page.words = Array(1000).fill({ kind: 'caption', text: 'MORE', panel: 0 });
  },
};

/** @param {import('../malformed-files.js').Malformed} file */
const asFile = ({ name, bytes }) => ({
  name,
  mimeType: name.endsWith('png') ? 'image/png' : 'application/zip',
  buffer: bytes,
});

test('rejected files do not change the open project, its records, its photos and its undo history', async ({
  page,
}) => {
  await first(page);
  const good = await goodFiles(page);
  const before = await all(page);
  for (const [what, spoil] of Object.entries(REFUSED)) {
    for (const [parts, make] of /** @type {const} */ ([
      [good.project, soundProject],
      [good.page, soundPage],
    ])) {
      await test.step(`${make.name}: ${what}`, async () => {
        const document = structuredClone(parts.document);
        spoil(document);
        const file = await make({ ...parts, document });
        await drop(page, [asFile(file)]);
        await expect(page.getByRole('alert').getByText(`${file.name} could not be opened`)).toBeVisible();
        await idle(page);
        expect(await all(page)).toEqual(before);
        await page.getByRole('alert').getByRole('button', { name: 'Dismiss' }).first().click();
      });
    }
  }
  // Some seconds after the start, the app deletes records that are not used.
  await page.clock.install();
  await page.reload();
  await idle(page);
  for (let i = 0; i < 3; i += 1) {
    await page.clock.runFor(10_000);
    expect(await all(page)).toEqual(before);
  }
});

test('a project that the engine rejects changes nothing', async ({ page }) => {
  await page.route(/assets\/worker-[^/]*\.js$/, async (route) => {
    const response = await route.fetch();
    const script = `addEventListener('message', (event) => {
      const { id, args } = event.data;
      if (!String(args?.document).includes('"text":"REFUSE THIS"')) return;
      event.stopImmediatePropagation();
      postMessage({ id, error: { code: 'invalid-document', message: 'words: cannot be drawn' }, memory: 0 });
    });`;
    await route.fulfill({ response, body: `${script}\n${await response.text()}` });
  });
  await first(page);
  const good = await goodFiles(page);
  const before = await all(page);
  good.project.document.history.present.page.words[0].text = 'REFUSE THIS';
  await drop(page, [asFile(await soundProject(good.project))]);
  await expect(
    page.getByRole('alert').getByText('sound.inkpanel could not be opened: words: cannot be drawn'),
  ).toBeVisible();
  await idle(page);
  expect(await all(page)).toEqual(before);
});

test('a project that cannot be shown is rejected, and an edit that cannot be shown can be reverted', async ({
  page,
}) => {
  const id = await first(page);
  const good = await goodFiles(page);
  const before = await all(page);
  // The views throw an error when they format one number.
  await page.evaluate(() => {
    const own = /** @type {PropertyDescriptor} */ (
      Object.getOwnPropertyDescriptor(Intl.NumberFormat.prototype, 'format')
    );
    Object.assign(window, { trap: 0.0777 });
    Object.defineProperty(Intl.NumberFormat.prototype, 'format', {
      ...own,
      get() {
        const format = own.get?.call(this);
        return (/** @type {number} */ value) => {
          if (Math.abs(value - /** @type {any} */ (window).trap) < 1e-6)
            throw new Error('a view that cannot draw this');
          return format(value);
        };
      },
    });
  });
  const { present } = good.project.document.history;
  present.page.page.gutter = present.settings.gutter = 0.0777;
  await drop(page, [asFile(await soundProject(good.project))]);
  await expect(page.getByRole('alert').getByText('sound.inkpanel could not be opened')).toBeVisible();
  await idle(page);
  expect(await all(page)).toEqual(before);
  // An edit that the views cannot draw.
  await page.evaluate(() => {
    Object.assign(window, { trap: 0.033 });
  });
  await tab(page, 'Page');
  await page.getByRole('slider', { name: 'Gutter' }).fill('3.3');
  const broken = page.getByRole('group', { name: 'First cannot be shown: part of it cannot be drawn.' });
  await expect(broken).toBeVisible();
  await accessible(page);
  await broken.getByRole('button', { name: 'Open another' }).click();
  await expect(page.getByRole('region', { name: 'Projects' }).getByRole('listitem')).not.toHaveCount(0);
  await broken.getByRole('button', { name: 'Restore the last good version' }).click();
  await idle(page);
  expect(await contents(page)).toEqual(before.contents);
  expect(await picture(page)).toBe(before.picture);
  await expectSaved(page);
  expect(await idOf(page)).toBe(id);
  await page.reload();
  await idle(page);
  expect(await contents(page)).toEqual(before.contents);
});

test('text with unpaired surrogates can be stored and read again', async ({ page }) => {
  const id = await first(page);
  await write(page, 'caption', 'a\ud800b');
  await page.getByLabel('Project name').fill('x\udc00y');
  await page.keyboard.press('Enter');
  await expectSaved(page);
  expect((await tables(page, { of: id })).projects[id].name).toBe('x\ufffdy');
  await page.reload();
  await idle(page);
  await expect(word(page, 'Caption: a\ufffdb')).toBeVisible();
  await expect(page.getByLabel('Project name')).toHaveValue('x\ufffdy');
});

test('a page holds 200 text items, and a message reports the limit', async ({ page }) => {
  await first(page);
  const good = await goodFiles(page);
  good.project.document.history.present.page.words = Array(200).fill({
    kind: 'caption',
    text: 'MORE',
    panel: 0,
    auto: false,
    x: 0.5,
    y: 0.5,
    size: 0.01,
  });
  await drop(page, [asFile(await soundProject(good.project))]);
  await expect(page.getByLabel('Project name')).toHaveValue('Malformed');
  await idle(page);
  await tab(page, 'Text');
  await page.getByRole('button', { name: 'Add caption' }).click();
  await expect(page.getByRole('alert').getByText('A page can have at most 200 text items.')).toBeVisible();
  await expectSaved(page);
  await page.reload();
  await idle(page);
  await expect(page.locator('[data-word]')).toHaveCount(200);
});
