// @ts-check
/** Checks that all texts and controls of a screen can be seen. */

/** @typedef {import('../../../www/testing.ts').Page} Page */

/** Returns controls that cannot be scrolled into view, and controls that cut off their text. @param {Page} page */
export function unreachable(page) {
  return page.evaluate(() => {
    const wrong = [];
    const scrolls = (/** @type {Element | null} */ of, /** @type {'X' | 'Y'} */ way) => {
      for (let box = of; box && box !== document.body; box = box.parentElement) {
        if (/auto|scroll/.test(getComputedStyle(box)[`overflow${way}`])) return true;
      }
      return false;
    };
    for (const element of document.querySelectorAll(
      'button, input:not([type=file]), select, summary, textarea, [role=slider], [role=option], .panel',
    )) {
      // A workspace covers the board, and a dialog covers everything.
      const cover = document.querySelector('dialog[open]') ?? document.querySelector('.workspace');
      if (
        !element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) ||
        (cover && !cover.contains(element))
      )
        continue;
      const { left, right, top, bottom, width } = element.getBoundingClientRect();
      const name = element.getAttribute('aria-label') ?? element.textContent?.slice(0, 40);
      if (width === 0) continue;
      if ((right > innerWidth + 1 || left < -1) && !scrolls(element, 'X')) wrong.push(`${name}: beside the window`);
      if ((bottom > innerHeight + 1 || top < -1) && !scrolls(element, 'Y'))
        wrong.push(`${name}: above or below the window`);
      const { overflowX, textOverflow } = getComputedStyle(element);
      if (
        element.matches('button') &&
        overflowX !== 'visible' &&
        textOverflow !== 'ellipsis' &&
        element.scrollWidth > element.clientWidth + 1
      )
        wrong.push(`${name}: cut off`);
    }
    if (document.documentElement.scrollWidth > innerWidth) wrong.push('the page scrolls sideways');
    return wrong;
  });
}

/**
 * Returns texts that are cut off by a box around them, or that extend beyond their control. Text in scrollable boxes can be
 * read. Names of files and projects may have any length.
 * @param {Page} page
 */
export function cutTexts(page) {
  return page.evaluate(() => {
    /** @type {string[]} */
    const wrong = [];
    const OWN = '.photo-name, .project-about, .stack-name, .project-name, [data-own-name]';
    const cover = document.querySelector('dialog[open]') ?? document.querySelector('.workspace');
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const element = /** @type {HTMLElement} */ (node.parentElement);
      const text = (node.textContent ?? '').trim();
      if (text === '' || element.closest('script, style, noscript, option, .visually-hidden') || element.closest(OWN))
        continue;
      if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
      if (cover && !cover.contains(element)) continue;
      const range = document.createRange();
      range.selectNodeContents(node);
      const words = range.getBoundingClientRect();
      // Text for screen readers is one pixel wide.
      if (words.width === 0 || element.clientWidth === 1) continue;
      // Half a pixel more or less is rounding.
      const beyond = (/** @type {DOMRect} */ box, /** @type {boolean} */ across, /** @type {boolean} */ along) =>
        (across && (words.right > box.right + 1.5 || words.left < box.left - 1.5)) ||
        (along && (words.bottom > box.bottom + 4 || words.top < box.top - 4));
      const control = element.closest('button, summary, [role=option], [role=tab], .chip, .toast');
      if (control && beyond(control.getBoundingClientRect(), true, true))
        wrong.push(`${text}: reaches out of its control`);
      let [across, along] = [true, true];
      for (
        let box = element;
        box && box !== document.documentElement;
        box = /** @type {HTMLElement} */ (box.parentElement)
      ) {
        const { overflowX, overflowY } = getComputedStyle(box);
        // Text in a scrollable box can be read.
        if (/auto|scroll/.test(overflowX)) across = false;
        if (/auto|scroll/.test(overflowY)) along = false;
        const [clipsX, clipsY] = [/hidden|clip/.test(overflowX), /hidden|clip/.test(overflowY)];
        if (beyond(box.getBoundingClientRect(), across && clipsX, along && clipsY)) {
          wrong.push(`${text}: cut off by ${box.className || box.tagName}`);
          break;
        }
        if (getComputedStyle(box).position === 'fixed') break;
      }
    }
    const pen = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));
    for (const field of document.querySelectorAll('select, input[placeholder], input[type=number]')) {
      if (!field.checkVisibility({ visibilityProperty: true }) || (cover && !cover.contains(field))) continue;
      const { font, paddingLeft, paddingRight } = getComputedStyle(field);
      // A list with a disabled first option is a menu, which shows only this option.
      const texts =
        field instanceof HTMLSelectElement
          ? [...field.options].slice(0, field.options[0]?.disabled ? 1 : undefined).map(({ text }) => text)
          : // A custom name may have any length if the title has the full name.
            [
              /** @type {HTMLInputElement} */ (field).placeholder,
              ...[/** @type {HTMLInputElement} */ (field).value].filter(
                (value) => value !== field.getAttribute('title'),
              ),
            ];
      pen.font = font;
      const room = field.clientWidth - Number.parseFloat(paddingLeft) - Number.parseFloat(paddingRight);
      // The browser needs room for arrows.
      const { appearance } = getComputedStyle(field);
      const mark =
        appearance === 'textfield'
          ? 0
          : field instanceof HTMLSelectElement
            ? 20
            : field.matches('[type=number]')
              ? 15
              : 0;
      for (const text of texts) {
        const over = Math.round(pen.measureText(text).width - (room - mark));
        if (over > 1) wrong.push(`${text}: ${over} pixels too long for its field`);
      }
    }
    // Boxes that scroll vertically must not scroll horizontally.
    for (const box of document.querySelectorAll('.side-panel > *, .sheet-body, .tray, .lanes, .wall, .listbox, dialog'))
      if (box.checkVisibility({ visibilityProperty: true }) && box.scrollWidth > box.clientWidth + 1)
        wrong.push(`${box.className}: scrolls sideways by ${box.scrollWidth - box.clientWidth}`);
    if (document.documentElement.scrollWidth > innerWidth) wrong.push('the page scrolls sideways');
    return [...new Set(wrong)];
  });
}

/**
 * Returns labels of buttons and tabs that continue on another line within a word. Lines of Japanese end anywhere.
 * @param {Page} page
 */
export function brokenWords(page) {
  return page.evaluate(() => {
    /** @type {string[]} */
    const wrong = [];
    const cover = document.querySelector('dialog[open]') ?? document.querySelector('.workspace');
    for (const control of document.querySelectorAll('button, summary, [role=tab]')) {
      if (!control.checkVisibility({ visibilityProperty: true }) || (cover && !cover.contains(control))) continue;
      const walker = document.createTreeWalker(control, NodeFilter.SHOW_TEXT);
      for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const text = node.textContent ?? '';
        for (const { 0: word, index } of text.matchAll(/[\p{Script=Latin}\p{N}]+/gu)) {
          const range = document.createRange();
          range.setStart(node, index);
          range.setEnd(node, index + word.length);
          const lines = new Set([...range.getClientRects()].map(({ top }) => Math.round(top)));
          if (lines.size > 1) wrong.push(`${word} in ${text}`);
        }
      }
    }
    return [...new Set(wrong)];
  });
}
