// @ts-check
/** Words of storyboards of several pages. */

const count = (/** @type {number} */ n, /** @type {string} */ one) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const bookStrings = {
  book: {
    name: 'Pages',
    page: (/** @type {number} */ n, /** @type {number} */ of) => `Page ${n} of ${of}`,
    add: 'Add page',
    addHelp: 'Add a page to the storyboard, behind this one',
    addMore: (/** @type {number} */ left) => `Add a page to the storyboard: ${count(left, 'photo')} on no page yet`,
    tools: 'Page tools',
    remove: 'Remove page',
    earlier: 'Move page earlier',
    later: 'Move page later',
    spreadAlbum: 'Spread album over pages',
    spreadHelp: (/** @type {number} */ n) => `A storyboard of several pages with all ${n} photos, in their order`,
    styleAll: 'Use this style on all pages',
    left: (/** @type {number} */ n) => `${count(n, 'photo')} on no page`,
    reading: 'The photos are still being read.',
    removed: (/** @type {number} */ n) => `Page ${n} was removed.`,
    spread: (/** @type {number} */ photos, /** @type {number} */ pages) => `${count(photos, 'photo')} on ${count(pages, 'page')}.`,
    takeBack: 'Take it back',
    dragHelp: 'Drag to move it, or Alt with an arrow key',
  },
  // Versions of a page are what Shuffle makes; pages are what a storyboard is made of.
  version: (/** @type {number} */ n, /** @type {number} */ of) => `Version ${n} of ${of} of this page: see all that were shown`,
  previousHelp: 'Previous version of this page, as shown before',
  nextHelp: 'Next version of this page, as shown after',
  versionOf: (/** @type {number} */ n) => `of page ${n}`,
};
