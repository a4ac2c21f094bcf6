/** Words of projects, of saving, and of the pages shown. */

import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'the storage of this browser is full',
  refused: 'this browser keeps nothing for pages here',
};

export const storageStrings = {
  // Saving
  saveState: {
    empty: '',
    saving: 'Saving…',
    saved: 'Saved',
    missing: 'Not all saved',
    full: 'Not saved',
    refused: 'Not saved',
    failed: 'Not saved',
  },
  savingCount: (done: number, total: number) => `Saving ${done} of ${total}`,
  saveHelp: 'Work is kept in this browser, on this device',
  notSaved: (why: string, message: string) =>
    `Your work is not saved: ${TROUBLE[why] ?? message.replace(/\.$/, '')}. Everything is still here as long as this page is open.`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)} ${names.length === 1 ? 'is not saved: its file' : 'are not saved: their files'} can no longer be read. All else is saved.`,
  photosNotHere: (names: readonly string[], of: number) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} of ${of} photos` : one ? 'The photo' : `All ${of} photos`;
    return `${which} ${one ? 'is' : 'are'} not in this browser: ${some(names)}. Choose or drop ${one ? 'it' : 'them'}: each goes back to its place.`;
  },
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)} ${names.length === 1 ? 'is no longer in this browser; its' : 'are no longer in this browser; their'} frames are. To take others, add the film again.`,
  photosNeverSaved: (names: readonly string[]) =>
    `The page closed before ${some(names)} ${names.length === 1 ? 'was' : 'were'} saved. Choose ${names.length === 1 ? 'it' : 'them'} again.`,
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
  openNamed: (name: string) => `Open ${name}`,
  duplicateNamed: (name: string) => `Duplicate ${name}`,
  deleteNamed: (name: string) => `Delete ${name}`,
  renameNamed: (name: string) => `Rename ${name}`,
  newNameOf: (name: string) => `New name of ${name}`,
  sampleAlbum: 'Sample album',
  openNow: 'Open now',
  projectAbout: (photos: number, when: string) =>
    `${photos === 1 ? '1 photo' : `${photos} photos`}${when && `, ${when}`}`,
  noProjects: 'What you make is saved here by itself.',
  projectDeleted: (name: string) => `${name} was deleted.`,
  bringBack: 'Restore',
  projectNotOpened: (why: string) => `The project could not be opened: ${why}`,
  projectFileNotOpened: (name: string, why: string) => `${name} could not be opened: ${why}`,
  projectNotSaved: (why: string) => `The project could not be saved as a file: ${why}`,
  projectReasons: {
    'damaged-project': 'it is damaged, or no project of Inkpanel. What is on the page was not touched.',
    'too-large-project': 'it holds more than a project can, or unpacks to more. What is on the page was not touched.',
    'silent-project': 'nothing of it could be read for a minute. Check the disk that it is on, and try again.',
    'newer-project': 'it was made by a newer Inkpanel. Load this page again to get the newest one.',
    'not-saved': 'what is on the page is not saved. Save it to a file first (Save project).',
    'missing-project': 'it was deleted.',
    'no-storage': 'this browser keeps nothing for pages here.',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `${others.length + 1} projects were opened, each on its own. ${shown} is on the page; ${others.length === 1 ? `${others[0]} is` : `${others.length} more are`} in Projects.`,
  photosWithProject: (n: number, name: string) =>
    `${n === 1 ? 'The photo that came along was' : `The ${n} photos that came along were`} added to ${name}.`,
  projectBroken: (name: string, why: string) => `${name} cannot be shown: ${why}.`,
  brokenReasons: {
    'damaged-project': 'part of it is damaged',
    'too-large-project': 'it holds more than a project can',
    'newer-project': 'it was made by a newer Inkpanel. Load this page again to get the newest one',
  } as Record<string, string>,
  brokenOtherwise: 'part of it cannot be drawn',
  brokenKept: 'It is kept as it is, with its photos.',
  partsLeftOut: (name: string, n: number) =>
    `${name} is open without ${n === 1 ? 'a part' : `${n} parts`} that could not be read.`,
  openAnother: 'Open another',
  saveAsFile: 'Save as file',
  goBack: 'Back to the last good state',
  noGoodState: 'No state of it is left to go back to.',
  wentBack: (name: string) => `${name} is back as it was when it was last drawn.`,
  openingProject: (name: string) => `Opening ${name}`,
  openingLast: 'Opening your project',
  openElsewhere: (name: string) => `${name} is open in another tab.`,
  opensWhenFree: 'It opens here when that tab is closed.',
  openCopy: 'Open a copy',

  // Pages shown
  pagesShown: 'Pages shown',
  pagesShownAt: (n: number, of: number) => `Pages shown, ${n}/${of}`,
  pageNumber: (n: number) => `Page ${n}`,
  pageFrom: (n: number) => `from page ${n}`,
  favouritePage: 'Favourite page',
  favouritePages: 'Favourites only',
  noFavouritePages: 'No favourites yet. Press the heart on a page you like.',
};
