/** Words of projects, of saving, and of the pages shown. */

import { some } from './png.ts';

const TROUBLE: Record<string, string> = {
  full: 'the storage of this browser is full',
  refused: 'this browser blocks site storage here',
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
  saveHelp: 'Your work is saved in this browser, on this device',
  notSaved: (why: string, message: string) =>
    `Your work is not saved: ${TROUBLE[why] ?? message.replace(/\.$/, '')}. It is lost when you close this tab.`,
  photosUnreadable: (names: readonly string[]) =>
    `${some(names)} ${names.length === 1 ? 'is not saved: its file' : 'are not saved: their files'} can no longer be read. Everything else is saved.`,
  photosNotHere: (names: readonly string[], of: number) => {
    const one = names.length === 1;
    const which = names.length < of ? `${names.length} of ${of} photos` : one ? 'The photo' : `All ${of} photos`;
    return `${which} ${one ? 'is' : 'are'} not in this browser: ${some(names)}. Choose or drop ${one ? 'it' : 'them'} to restore ${one ? 'it' : 'them'}.`;
  },
  filmsNotHere: (names: readonly string[]) =>
    `${some(names)} ${names.length === 1 ? 'is' : 'are'} no longer in this browser, but the frames are. To use other frames, add the video again.`,
  photosNeverSaved: (names: readonly string[]) =>
    `The app closed before ${some(names)} ${names.length === 1 ? 'was' : 'were'} saved. Choose ${names.length === 1 ? 'it' : 'them'} again.`,
  saveAgain: 'Save again',
  goOnWithout: 'Continue without',
  saveToFile: 'Save to file',
  conflict: 'Another tab changed this project. This tab continues with a copy.',

  // Projects
  projects: 'Projects',
  projectName: 'Project name',
  untitled: 'Untitled',
  newProject: 'New project',
  openProject: 'Open project file',
  saveProject: 'Save project file',
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
  noProjects: 'Your work is saved here automatically.',
  projectDeleted: (name: string) => `${name} was deleted.`,
  bringBack: 'Restore',
  projectNotOpened: (why: string) => `The project could not be opened: ${why}`,
  projectFileNotOpened: (name: string, why: string) => `${name} could not be opened: ${why}`,
  projectNotSaved: (why: string) => `The project could not be saved as a file: ${why}`,
  projectReasons: {
    'damaged-project': 'it is damaged, or it is not an Inkpanel project. Your page was not changed.',
    'too-large-project': 'it exceeds the limits of a project. Your page was not changed.',
    'silent-project': 'reading the file timed out after a minute. Check the drive and try again.',
    'newer-project': 'it was saved by a newer version of Inkpanel. Reload this tab to update.',
    'not-saved': 'your current work is not saved. Save it to a file first (Save project file).',
    'missing-project': 'it was deleted.',
    'no-storage': 'this browser blocks site storage here.',
  } as Record<string, string>,
  projectsOpened: (others: readonly string[], shown: string) =>
    `${others.length + 1} projects were opened separately. ${shown} is on the page; ${others.length === 1 ? `${others[0]} is` : `${others.length} more are`} in Projects.`,
  photosWithProject: (n: number, name: string) =>
    `${n === 1 ? 'The photo from the same drop was' : `The ${n} photos from the same drop were`} added to ${name}.`,
  projectBroken: (name: string, why: string) => `${name} cannot be shown: ${why}.`,
  brokenReasons: {
    'damaged-project': 'part of it is damaged',
    'too-large-project': 'it exceeds the limits of a project',
    'newer-project': 'it was saved by a newer version of Inkpanel. Reload this tab to update',
  } as Record<string, string>,
  brokenOtherwise: 'part of it cannot be drawn',
  brokenKept: 'The project and its photos are unchanged.',
  partsLeftOut: (name: string, n: number) =>
    `${name} is open without ${n === 1 ? 'a part' : `${n} parts`} that could not be read.`,
  openAnother: 'Open another',
  saveAsFile: 'Save as file',
  goBack: 'Restore the last good version',
  noGoodState: 'There is no earlier version to restore.',
  wentBack: (name: string) => `The last good version of ${name} was restored.`,
  openingProject: (name: string) => `Opening ${name}`,
  openingLast: 'Opening your project',
  openElsewhere: (name: string) => `${name} is open in another tab.`,
  opensWhenFree: 'It opens here when you close the other tab.',
  openCopy: 'Open a copy',

  // Versions
  pagesShown: 'Page history',
  pagesShownAt: (n: number, of: number) => `Page history, ${n}/${of}`,
  pageNumber: (n: number) => `Page ${n}`,
  versionFrom: (n: number) => `from version ${n}`,
  favouritePage: 'Favourite page',
  favouritePages: 'Favourites only',
  versionNumber: (n: number) => `Version ${n}`,
  compareShort: 'Compare',
  comparePage: (n: number) => `Compare version ${n}`,
  comparedAll: 'Show all versions',
  compareSecond: 'Select the second version to compare',
  noFavouritePages: 'No favourites yet. Press the heart on a page you like.',
};
