// @ts-check
/** Words of projects, of saving, and of the pages shown. */

import { some } from './png.js';

/** @type {Record<string, string>} */
const TROUBLE = {
  full: 'the storage of this browser is full',
  refused: 'this browser keeps nothing for pages here',
};

export const keepingStrings = {

  // Saving
  saveState: {
    empty: '', saving: 'Saving…', saved: 'Saved', missing: 'Not all saved', full: 'Not saved', refused: 'Not saved', failed: 'Not saved',
  },
  savingCount: (/** @type {number} */ done, /** @type {number} */ total) => `Saving ${done} of ${total}`,
  saveHelp: 'Work is kept in this browser, on this device',
  notSaved: (/** @type {string} */ why, /** @type {string} */ message) => (
    `Your work is not saved: ${TROUBLE[why] ?? message.replace(/\.$/, '')}. Everything is still here as long as this page is open.`
  ),
  photosUnreadable: (/** @type {readonly string[]} */ names) => (
    `${some(names)} ${names.length === 1 ? 'is not saved: its file' : 'are not saved: their files'} can no longer be read. All else is saved.`
  ),
  photosNotHere: (/** @type {readonly string[]} */ names, /** @type {number} */ of) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} of ${of} photos` : one ? 'The photo' : `All ${of} photos`;
    return `${which} ${one ? 'is' : 'are'} not in this browser: ${some(names)}. Choose or drop ${one ? 'it' : 'them'}: each goes back to its place.`;
  },
  filmsNotHere: (/** @type {readonly string[]} */ names) => (
    `${some(names)} ${names.length === 1 ? 'is no longer in this browser; its' : 'are no longer in this browser; their'} frames are. To take others, add the film again.`
  ),
  photosNeverSaved: (/** @type {readonly string[]} */ names) => (
    `The page closed before ${some(names)} ${names.length === 1 ? 'was' : 'were'} saved. Choose ${names.length === 1 ? 'it' : 'them'} again.`
  ),
  saveAgain: 'Save again',
  goOnWithout: 'Go on without',
  saveToFile: 'Save to file',
  conflict: 'Another tab changed this project, so this one goes on as a copy.',

  // Projects
  projects: 'Projects',
  projectName: 'Project name',
  untitled: 'Untitled',
  newProject: 'New project',
  openProject: 'Open project',
  saveProject: 'Save project',
  projectFile: 'Project file',
  openNamed: (/** @type {string} */ name) => `Open ${name}`,
  duplicateNamed: (/** @type {string} */ name) => `Duplicate ${name}`,
  deleteNamed: (/** @type {string} */ name) => `Delete ${name}`,
  openNow: 'Open now',
  projectAbout: (/** @type {number} */ photos, /** @type {string} */ when) => `${photos === 1 ? '1 photo' : `${photos} photos`}${when && `, ${when}`}`,
  noProjects: 'What you make is saved here by itself.',
  projectDeleted: (/** @type {string} */ name) => `${name} was deleted.`,
  bringBack: 'Bring it back',
  projectNotOpened: (/** @type {string} */ why) => `The project could not be opened: ${why}`,
  projectFileNotOpened: (/** @type {string} */ name, /** @type {string} */ why) => `${name} could not be opened: ${why}`,
  projectNotSaved: (/** @type {string} */ why) => `The project could not be saved as a file: ${why}`,
  /** @type {Record<string, string>} */
  projectReasons: {
    'damaged-project': 'it is damaged, or no project of Inkpanel. What is on the page was not touched.',
    'too-large-project': 'it holds more than a project can, or unpacks to more. What is on the page was not touched.',
    'silent-project': 'nothing of it could be read for a minute. Check the disk that it is on, and try again.',
    'newer-project': 'it was made by a newer Inkpanel. Load this page again to get the newest one.',
    'not-saved': 'what is on the page is not saved. Save it to a file first (Save project).',
    'missing-project': 'it was deleted.',
    'no-storage': 'this browser keeps nothing for pages here.',
  },
  /** @param {readonly string[]} others @param {string} shown */
  projectsOpened: (others, shown) => (
    `${others.length + 1} projects were opened, each on its own. ${shown} is on the page; ${others.length === 1 ? `${others[0]} is` : `${others.length} more are`} in Projects.`
  ),
  photosWithProject: (/** @type {number} */ n, /** @type {string} */ name) => `${n === 1 ? 'The photo that came along was' : `The ${n} photos that came along were`} added to ${name}.`,
  projectBroken: (/** @type {string} */ name, /** @type {string} */ why) => `${name} cannot be shown: ${why}.`,
  /** @type {Record<string, string>} */
  brokenReasons: {
    'damaged-project': 'part of it is damaged',
    'newer-project': 'it was made by a newer Inkpanel. Load this page again to get the newest one',
  },
  brokenOtherwise: 'part of it cannot be drawn',
  brokenKept: 'It is kept as it is, with its photos.',
  partsLeftOut: (/** @type {string} */ name, /** @type {number} */ n) => `${name} is open without ${n === 1 ? 'a part' : `${n} parts`} that could not be read.`,
  openAnother: 'Open another',
  saveAsFile: 'Save as file',
  goBack: 'Back to the last good state',
  noGoodState: 'No state of it is left to go back to.',
  wentBack: (/** @type {string} */ name) => `${name} is back as it was when it was last drawn.`,
  openingProject: (/** @type {string} */ name) => `Opening ${name}`,
  openingLast: 'Opening your project',
  openElsewhere: (/** @type {string} */ name) => `${name} is open in another tab.`,
  opensWhenFree: 'It opens here when that tab is closed.',
  openCopy: 'Open a copy',

  // Pages shown
  pagesShown: 'Pages shown',
  pagesShownAt: (/** @type {number} */ n, /** @type {number} */ of) => `Pages shown, ${n}/${of}`,
  pageNumber: (/** @type {number} */ n) => `Page ${n}`,
  pageFrom: (/** @type {number} */ n) => `from page ${n}`,
  favouritePage: 'Favourite page',
  favouritePages: 'Favourites only',
  noFavouritePages: 'No favourites yet. Press the heart on a page you like.',
};
