/** Words of storyboards of several pages. */

const count = (n: number, one: string) => (n === 1 ? `1 ${one}` : `${n} ${one}s`);

export const bookStrings = {
  book: {
    name: 'Pages',
    page: (n: number, of: number) => `Page ${n} of ${of}`,
    add: 'Add page',
    addHelp: 'Insert a page after this one',
    addMore: (left: number) => `Insert a page after this one: ${count(left, 'photo')} not used yet`,
    tools: 'Page tools',
    remove: 'Remove page',
    turnBack: 'Previous page',
    turnOn: 'Next page',
    earlier: 'Move page earlier',
    later: 'Move page later',
    make: 'Make a book',
    makeHelp: (n: number) => `A cover, chapters by day, captions and page numbers, with your ${count(n, 'photo')}`,
    makeChapters: 'Make a book, one style per day',
    makeChaptersHelp: 'Like “Make a book”, with another style for each day',
    made: (n: number) => `Your book has ${count(n, 'page')}.`,
    looking: 'Looking at your photos…',
    making: (done: number, of: number) => `Page ${done + 1} of ${of}…`,
    spreadAlbum: 'Make pages from all photos',
    spreadHelp: (n: number) => `Creates several pages with all ${n} photos, in their order`,
    spreadAsk: 'The new pages replace your pages, including your edits.',
    spreadYes: 'Replace pages',
    styleAll: 'Use this style on all pages',
    left: (n: number) => `${count(n, 'photo')} on no page`,
    reading: 'Inkpanel is still reading the photos.',
    removed: (n: number) => `Page ${n} was removed.`,
    spread: (photos: number, pages: number) => `${count(photos, 'photo')} on ${count(pages, 'page')}.`,
    repeats: (n: number) => `There are not enough unused photos. This page repeats ${count(n, 'photo')}.`,
    takeBack: 'Restore pages',
    dragHelp: 'Drag to move, or press Alt with an arrow key',
  },
  // Versions of a page are what Shuffle makes; pages are what a storyboard is made of.
  version: (n: number, of: number) => `Version ${n} of ${of} of this page: show all versions`,
  previousHelp: 'Show the previous version of this page',
  nextHelp: 'Show the next version of this page',
};
