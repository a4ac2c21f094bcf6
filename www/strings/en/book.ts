/** Words of storyboards of several pages. */

const count = (n: number, one: string) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const bookStrings = {
  book: {
    name: 'Pages',
    page: (n: number, of: number) => `Page ${n} of ${of}`,
    add: 'Add page',
    addHelp: 'Add a page to the storyboard, behind this one',
    addMore: (left: number) => `Add a page to the storyboard: ${count(left, 'photo')} on no page yet`,
    tools: 'Page tools',
    remove: 'Remove page',
    turnBack: 'Turn back a page',
    turnOn: 'Turn on a page',
    earlier: 'Move page earlier',
    later: 'Move page later',
    spreadAlbum: 'Spread album over pages',
    spreadHelp: (n: number) => `A storyboard of several pages with all ${n} photos, in their order`,
    styleAll: 'Use this style on all pages',
    left: (n: number) => `${count(n, 'photo')} on no page`,
    reading: 'The photos are still being read.',
    removed: (n: number) => `Page ${n} was removed.`,
    spread: (photos: number, pages: number) => `${count(photos, 'photo')} on ${count(pages, 'page')}.`,
    takeBack: 'Take it back',
    dragHelp: 'Drag to move it, or Alt with an arrow key',
  },
  // Versions of a page are what Shuffle makes; pages are what a storyboard is made of.
  version: (n: number, of: number) => `Version ${n} of ${of} of this page: see all that were shown`,
  previousHelp: 'Previous version of this page, as shown before',
  nextHelp: 'Next version of this page, as shown after',
  versionOf: (n: number) => `of page ${n}`,
};
