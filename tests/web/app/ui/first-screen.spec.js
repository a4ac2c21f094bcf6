// @ts-check
/** The first screens: the start screen, the size of the comic page, and the number of controls. */

import { panel } from '../panels.js';
import {
  SAMPLES,
  accessible,
  expect,
  idle,
  openBoard,
  openNewBoard,
  openStart,
  press,
  reach,
  test,
} from '../support.js';

/** @typedef {import('../support.js').Page} Page */

/** Parts of the page and thumbnails: of photos, styles, layouts, suggestions, pages and projects. */
const THUMBNAILS = '.page, .photos, .listbox, .strip, .book-pages, .recent';

/**
 * The names of the visible controls besides thumbnails.
 * @param {Page} page
 * @returns {Promise<string[]>}
 */
const controls = (page) =>
  page.evaluate((thumbnails) => {
    const all = document.querySelectorAll(
      'button, summary, select, textarea, a[href], input:not([type=file]), [role=button], [role=slider], [role=tab]',
    );
    return [...all]
      .filter((one) => !one.closest(thumbnails))
      .filter((one) => one.checkVisibility({ visibilityProperty: true, opacityProperty: true }))
      .map((one) => [one.getBoundingClientRect(), one.getAttribute('aria-label') ?? one.textContent ?? ''])
      .filter(([box]) => {
        const { left, top, right, bottom, width } = /** @type {DOMRect} */ (box);
        return width > 1 && right > 0 && bottom > 0 && left < innerWidth && top < innerHeight;
      })
      .map(([, name]) => /** @type {string} */ (name));
  }, THUMBNAILS);

/** The part of the window that the comic page covers. @param {Page} page */
const share = (page) =>
  page.locator('.page-canvas').evaluate((canvas) => {
    const { width, height } = canvas.getBoundingClientRect();
    return (width * height) / (innerWidth * innerHeight);
  });

for (const viewport of [
  { width: 1440, height: 900 },
  { width: 1280, height: 720 },
]) {
  test.describe(`${viewport.width} x ${viewport.height} pixels`, () => {
    test.use({ viewport });

    test('the page has a third of the window, and there are at most 25 controls', async ({ page }) => {
      await openNewBoard(page, SAMPLES);
      await page.mouse.move(viewport.width / 2, 60);
      expect(await share(page)).toBeGreaterThanOrEqual(0.33);
      const names = await controls(page);
      console.log(viewport.width, names.length, (await share(page)).toFixed(3), names.join(' | '));
      expect(names.length, names.join(', ')).toBeLessThanOrEqual(25);
      for (const name of ['Comic', 'Storyboard', 'Style designer', 'Explore styles', 'Export', 'Download PNG'])
        await expect(page.locator('.top-bar').getByRole('button', { name, exact: true })).toBeVisible();
      await accessible(page);
    });

    test('a panel has five tools and More, without a larger page or a smaller one', async ({ page }) => {
      await openNewBoard(page, SAMPLES);
      const before = await share(page);
      await panel(page, 1).click();
      const tools = page.getByRole('toolbar', { name: 'Panel tools' }).getByRole('button');
      await expect(tools).toHaveText(['Lock', 'Crop', 'Replace', 'Star', 'Split panel', 'More']);
      expect(await share(page)).toBeCloseTo(before, 3);
      await tools.last().click();
      // A disabled tool explains why it is disabled.
      await expect(tools.filter({ hasText: 'Reset' })).toContainText('the crop is the automatic one');
      // The request to select a panel covers no tool.
      await tools.filter({ hasText: 'Swap' }).click();
      const hint = await page.getByText('Select the panel to swap with').boundingBox();
      const list = await page.getByRole('toolbar', { name: 'Panel tools' }).boundingBox();
      expect(hint?.y).toBeGreaterThanOrEqual((list?.y ?? 0) + (list?.height ?? 0));
      await accessible(page);
    });
  });
}

test('a click next to the page, another version, full screen and Escape end each selection', async ({ page }) => {
  await openBoard(page);
  const tools = page.getByRole('toolbar', { name: 'Panel tools' });
  const bar = page.getByRole('toolbar', { name: 'Lettering tools' });
  const area = await page.locator('.stage-area').boundingBox();
  if (!area) throw new Error('no stage');
  const beside = () => page.mouse.click(area.x + 8, area.y + area.height / 2);
  const selectText = async () => {
    await page.locator('.word').first().click();
    await expect(bar.first()).toBeVisible();
  };
  await panel(page, 1).click();
  await expect(tools.getByRole('button', { name: 'Crop' })).toBeVisible();
  await beside();
  await expect(tools.getByRole('button', { name: 'Crop' })).toHaveCount(0);
  await page.getByRole('tab', { name: 'Text' }).click();
  await page.getByRole('button', { name: 'Add balloon' }).click();
  await page.keyboard.press('Escape');
  await idle(page);
  await beside();
  await expect(bar).toHaveCount(0);
  for (const end of [
    beside,
    () => page.keyboard.press('Escape'),
    () => panel(page, 1).click({ position: { x: 5, y: 5 } }),
    () => press(page, 'Shuffle style'),
    () => page.keyboard.press('f'),
  ]) {
    await selectText();
    // One bar at a time.
    await expect(tools.getByRole('button', { name: 'Crop' })).toHaveCount(0);
    await end();
    await expect(bar).toHaveCount(0);
    // Keys do not reach a text item that is not selected.
    await expect(page.locator('.word:focus')).toHaveCount(0);
    await page.keyboard.press('Escape');
  }
});

test('Star enlarges the panel of the photo on this page and changes nothing else', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('tab', { name: 'Layouts' }).click();
  await page.getByRole('combobox', { name: 'Family' }).selectOption('grid');
  await page.getByRole('option', { name: 'Four', exact: true }).click();
  await idle(page);
  const panels = page.getByRole('group', { name: /^Panel \d of 4$/ });
  const photos = () =>
    panels.evaluateAll((all) => all.map((one) => one.getAttribute('aria-description')?.split(',')[0]));
  const area = async () => {
    const box = await panel(page, 2).boundingBox();
    return (box?.width ?? 0) * (box?.height ?? 0);
  };
  await panel(page, 2).click();
  const [before, small] = [await photos(), await area()];
  await press(page, 'Star');
  await expect.poll(area).toBeGreaterThan(1.3 * small);
  expect(await photos()).toEqual(before);
  // The panel is still selected, and one Undo takes back star and size.
  await expect(page.getByRole('button', { name: 'Star', exact: true, pressed: true })).toBeVisible();
  await press(page, 'Undo');
  await expect.poll(area).toBeCloseTo(small, -1);
});

test('Crop has its own tools, and Replace takes the next photo that is pressed', async ({ page }) => {
  await openBoard(page);
  await panel(page, 1).click();
  await press(page, 'Crop');
  const tools = page.getByRole('toolbar', { name: 'Panel tools' }).getByRole('button');
  await expect(tools.first()).toHaveText('Zoom in');
  await press(page, 'Zoom in');
  await press(page, 'Done');
  await press(page, 'Replace');
  await expect(page.getByText('Choose a photo for this panel')).toBeVisible();
  const photo = page.getByRole('region', { name: 'Photos' }).getByRole('button', { name: 'Choose temple.jpg' });
  await photo.click();
  await idle(page);
  await expect(panel(page, 1)).toHaveAttribute('aria-description', /temple\.jpg/);
  await expect(page.getByText('Choose a photo for this panel')).toHaveCount(0);
});

test('a panel is split and joined with the tools of the selection', async ({ page }) => {
  await openBoard(page);
  await page.getByRole('tab', { name: 'Layouts' }).click();
  await page.getByRole('combobox', { name: 'Family' }).selectOption('grid');
  await page.getByRole('option', { name: 'Four', exact: true }).click();
  await idle(page);
  await panel(page, 1).click();
  await press(page, 'Split panel');
  await expect(page.getByRole('group', { name: /^Panel \d of 5$/ })).toHaveCount(5);
  // The half is still selected, so it can be split again.
  const title = page.getByRole('toolbar', { name: 'Panel tools' });
  await expect(title).toContainText('Panel 1 of 5');
  await panel(page, 2).click({ modifiers: ['Shift'] });
  await expect(await reach(page, 'Join panels')).toHaveText('Join panels');
  await press(page, 'Join panels');
  await expect(page.getByRole('group', { name: /^Panel \d of 4$/ })).toHaveCount(4);
  await expect(title).toContainText('Panel 1 of 4');
});

test('a preview covers neither Shuffle nor the photos', async ({ page }) => {
  await openBoard(page);
  const box = async (/** @type {string} */ selector) => {
    const found = await page.locator(selector).boundingBox();
    if (!found) throw new Error(selector);
    return found;
  };
  const preview = async () => {
    await expect(page.locator('.glimpse')).toBeVisible();
    const [view, stage] = [await box('.glimpse'), await box('.stage')];
    expect(view.x).toBeGreaterThanOrEqual(stage.x);
    expect(view.x + view.width).toBeLessThanOrEqual(stage.x + stage.width);
    await page.mouse.move(0, 0);
    await expect(page.locator('.glimpse')).toHaveCount(0);
  };
  await page.getByRole('listbox', { name: 'Styles' }).getByRole('option').first().hover();
  await preview();
  await press(page, 'Show suggestions');
  const strip = page.getByRole('region', { name: 'Suggestions' });
  await strip.getByRole('button', { name: 'Suggestion 1', exact: true }).hover();
  await preview();
});

test('a list that opens below a resting pointer shows no preview until the pointer moves', async ({ page }) => {
  await openBoard(page);
  await page.evaluate(() => {
    const seen = /** @type {{ previews?: number }} */ (window);
    seen.previews = 0;
    new MutationObserver((changes) => {
      const added = changes.flatMap(({ addedNodes }) => [...addedNodes]);
      const previews = added.filter((one) => one instanceof Element && one.matches('.glimpse'));
      seen.previews = (seen.previews ?? 0) + previews.length;
    }).observe(document.body, { childList: true, subtree: true });
  });
  const previews = () => page.evaluate(() => /** @type {{ previews?: number }} */ (window).previews);
  // The pointer is where a suggestion will be.
  const idea = await page.evaluate(() => {
    const { left, right, bottom } = /** @type {Element} */ (document.querySelector('.app')).getBoundingClientRect();
    return { x: (left + right) / 2, y: bottom - 40 };
  });
  await page.mouse.move(idea.x, idea.y);
  await page.getByRole('button', { name: 'Show suggestions' }).dispatchEvent('click');
  const below = page.locator('.strip button:hover');
  await expect(below.locator('[data-drawn=true]')).toHaveCount(1);
  await idle(page);
  expect(await previews()).toBe(0);
  await page.mouse.move(idea.x + 150, idea.y, { steps: 5 });
  await expect(page.locator('.glimpse')).toBeVisible();
  expect(await previews()).toBeGreaterThan(0);
});

for (const viewport of [
  { width: 1440, height: 900 },
  { width: 1280, height: 720 },
  { width: 820, height: 1180 },
  { width: 390, height: 844 },
  { width: 844, height: 390 },
]) {
  test.describe(`${viewport.width} x ${viewport.height} pixels`, () => {
    test.use({ viewport });

    test('a message does not cover the page', async ({ page }) => {
      await openBoard(page);
      const broken = { name: 'broken.jpg', mimeType: 'image/jpeg', buffer: Buffer.from('no photo') };
      await page
        .locator('input[type=file]')
        .first()
        .setInputFiles([broken, { ...broken, name: 'other.jpg' }]);
      const message = page.locator('.toast');
      await expect(message.first()).toBeVisible();
      await idle(page);
      const art = await page.locator('.page-canvas').boundingBox();
      const box = await message.first().boundingBox();
      if (!art || !box) throw new Error('no message or no page');
      const isBeside = box.x >= art.x + art.width || box.x + box.width <= art.x;
      const isApart = isBeside || box.y >= art.y + art.height || box.y + box.height <= art.y;
      expect(isApart, JSON.stringify({ art, box })).toBe(true);
      expect(box.x + box.width).toBeLessThanOrEqual(viewport.width);
      expect(box.y + box.height).toBeLessThanOrEqual(viewport.height);
    });
  });
}

test('the start screen of an upright tablet has its text below large pages', async ({ page }) => {
  await page.setViewportSize({ width: 820, height: 1180 });
  await openStart(page);
  const pages = await page.getByRole('img', { name: 'Three comic pages made from the sample album' }).boundingBox();
  const heading = await page.locator('.start h1').boundingBox();
  if (!pages || !heading) throw new Error('no start screen');
  expect(pages.width).toBeGreaterThan(380);
  expect(heading.y).toBeGreaterThanOrEqual(pages.y + pages.height);
});

test('a message is at the lower right on every screen, where lists scroll', async ({ page }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await openBoard(page);
  const broken = { name: 'broken.jpg', mimeType: 'image/jpeg', buffer: Buffer.from('no photo') };
  await page.locator('input[type=file]').first().setInputFiles(broken);
  const message = page.locator('.toast');
  await expect(message).toBeVisible();
  for (const screen of ['Storyboard', 'Style designer', 'Projects']) {
    await press(page, screen);
    const box = await message.boundingBox();
    if (!box) throw new Error('no message');
    expect(box.x + box.width, screen).toBeGreaterThan(1400);
    expect(box.y + box.height, screen).toBeGreaterThan(860);
  }
});

test('the start screen shows three pages, and the projects of a person who returns', async ({ page }) => {
  await openStart(page);
  const pages = page.getByRole('img', { name: 'Three comic pages made from the sample album' });
  await expect(pages).toBeVisible();
  const sizes = () =>
    pages.locator('img').evaluateAll((all) => all.map((one) => /** @type {any} */ (one).naturalWidth > 0));
  await expect.poll(sizes).toEqual([true, true, true]);
  await expect(page.getByRole('region', { name: 'Recent projects' })).toHaveCount(0);
  await openBoard(page);
  await expect(page.locator('.save-state')).toHaveText('Saved', { timeout: 120_000 });
  const name = await page.getByRole('textbox', { name: 'Project name' }).inputValue();
  await press(page, 'Projects');
  await press(page, 'New project');
  await page.keyboard.press('Escape');
  const recent = page.getByRole('region', { name: 'Recent projects' });
  await expect(recent.getByRole('button')).toHaveCount(1);
  await page.setViewportSize({ width: 1280, height: 720 });
  const box = await recent.boundingBox();
  expect((box?.y ?? 720) + (box?.height ?? 0)).toBeLessThan(720);
  await accessible(page);
  await recent.getByRole('button', { name: `Open ${name}` }).click();
  await expect(page.getByRole('region', { name: 'Comic page' })).toBeVisible();
});

for (const viewport of [
  { width: 390, height: 844 },
  { width: 1280, height: 800 },
]) {
  test(`the pictures of the start screen come before the scripts and stay, in ${viewport.width} pixels`, async ({
    page,
  }) => {
    await page.setViewportSize(viewport);
    const scripts = await holdScripts(page);
    const pictures = page.locator('.start-pages img');
    const sizes = () => pictures.evaluateAll((all) => all.map((one) => /** @type {any} */ (one).naturalWidth > 0));
    await expect.poll(sizes).toEqual([true, true, true]);
    const before = await pictures.first().boundingBox();
    const first = await pictures.first().elementHandle();
    scripts.release();
    await expect(page.getByRole('button', { name: 'Choose photos or a video' })).toBeVisible();
    expect(await first?.evaluate((one) => one.isConnected)).toBe(true);
    const after = await pictures.first().boundingBox();
    expect(after?.x).toBe(before?.x);
    expect(Math.abs(Number(after?.y) - Number(before?.y))).toBeLessThan(24);
  });
}

test('the pictures of the start screen are hidden if a project opens', async ({ page }) => {
  await page.addInitScript(() => localStorage.setItem('inkpanel.project', 'a project'));
  const scripts = await holdScripts(page);
  const pictures = page.locator('.start-pages img');
  await expect(pictures).toHaveCount(3);
  await page.waitForFunction(() => document.styleSheets.length > 0);
  await expect(pictures.first()).toBeHidden();
  scripts.release();
  // This browser does not have the project.
  await expect(pictures.first()).toBeVisible();
});

/** Opens the app, whose scripts wait until they are released. @param {Page} page */
async function holdScripts(page) {
  let release = () => {};
  const released = new Promise((done) => {
    release = () => done(undefined);
  });
  await page.route('**/assets/*.js', async (route) => {
    await released;
    await route.continue();
  });
  await page.goto('./', { waitUntil: 'commit' });
  return { release };
}
