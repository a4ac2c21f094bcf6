/** The help, and the hints at first use. Names of controls come from their own strings. */

import { boardStrings as board } from './board.ts';
import { bookStrings } from './book.ts';
import { brushStrings } from './brush.ts';
import { designerStrings as designer } from './designer.ts';
import { imitationStrings as imitation } from './imitation.ts';
import { storageStrings as storage } from './storage.ts';
import { offlineStrings } from './offline.ts';
import { panelStrings as panels } from './panels.ts';
import { photoStrings as photos } from './photos.ts';
import { soundStrings } from './sounds.ts';
import { pngStrings } from './png.ts';
import { sideStrings as side } from './side.ts';
import { startStrings } from './start.ts';
import { wordStrings as words } from './words.ts';

const { filmSounds: sounds } = soundStrings;

const { book } = bookStrings;

const { brush } = brushStrings;

export const helpStrings = {
  help: 'Help and keyboard shortcuts',
  helpShort: 'Help',
  searchHelp: 'Search help',
  helpTopics: 'Topics',
  helpFound: (topics: number, keys: number) =>
    `Found: ${topics === 1 ? '1 topic' : `${topics} topics`}, ${keys === 1 ? '1 shortcut' : `${keys} shortcuts`}`,
  helpNone: (text: string) => `Nothing found for “${text}”. Try another word, or browse all topics.`,
  allTopics: 'Show all topics',
  hintsAgain: 'Show the hints again',
  hint: {
    shuffle: 'Shuffle until you like it. You can return to every page that you have seen.',
    crop: 'Drag to move the picture, scroll to zoom.',
    cropTouch: 'Drag to move the picture, pinch to zoom.',
    lock: 'Lock the parts that you like. Shuffle changes only the rest.',
  },
  topics: {
    adding: {
      title: 'Adding photos and videos',
      text: `Drop photos or videos anywhere on the window, paste them, or press “${photos.addPhotos}”. To try Inkpanel first, press “${startStrings.trySamples}”. You can add more at any time.`,
    },
    films: {
      title: 'Frames of a video',
      text: `Inkpanel extracts frames from a video. They behave like any other photo. Press the name of the video in the list of photos to set its start, its end and the number of frames; “${photos.takeFrames}” applies the settings. A panel that shows a frame can change to an earlier or a later one. “${sounds.hear}”, under “${side.sideTab.words}”, suggests sound effects for sounds near the frames on your pages.`,
    },
    shuffle: {
      title: 'Shuffling',
      text: `“${board.shuffle}” makes a new page of your photos, with another layout and another style. Next to it, “${board.part.layout}”, “${board.part.style}” and “${board.part.photos}” change only that part. On a phone you can also swipe the page to the side.`,
    },
    locks: {
      title: 'Locking parts of a page',
      text: `The lock next to “${board.part.layout}”, “${board.part.style}” or “${board.part.photos}” protects that part while you shuffle the rest. “${panels.lockPanel}” protects the photo of one panel and its crop. A photo with a star gets a large panel, here and in every shuffle.`,
    },
    versions: {
      title: 'Undo, versions and favourite pages',
      text: `“${board.undo}” and “${board.redo}” go through all of your changes. “${board.previous}” and “${board.next}” go through the pages that you have seen, and the number between them lists them all. The heart marks a page as a favourite.`,
    },
    ideas: {
      title: 'Suggestions',
      text: `The strip below the page, “${side.moreIdeas}”, shows other pages of the same photos. Click a page to use it. Point at a page to see it large.`,
    },
    layouts: {
      title: 'Layouts',
      text: `Choose a layout by its family and its number of panels; “${side.surprise}” generates one. With “${side.editLayout}” you drag the dividers between the panels, slant them, move insets, and split or remove panels. “${side.saveLayout}” saves the layout as a file and adds it to “${side.myLayouts}”.`,
    },
    joining: {
      title: 'Joining panels, and one photo across panels',
      text: `Turn on “${panels.selectPanels}” and select panels that touch. “${panels.joinPanels}” turns them into one panel, if together they have the shape of one. “${panels.merge}” keeps the panels and shows one photo across all of them; “${panels.split}” separates them again.`,
    },
    crop: {
      title: 'Moving and zooming a photo',
      text: `Drag the photo in its panel to move it, and turn the wheel or pinch to zoom. On a touch screen, tap the panel first. Double-click to fit the subject. “${panels.resetCrop}” restores the automatic crop. “${panels.rotatePhoto}” turns a photo that lies on its side, and “${panels.flipPhoto}” mirrors it; both change the photo on all pages.`,
    },
    exchange: {
      title: 'Exchanging photos',
      text: `Drag a photo out of its panel onto another panel to swap them; “${panels.swapPhoto}” does the same by clicks. Click a photo in the list, then a panel, to put the photo there. Untick a photo in the list to exclude it.`,
    },
    subject: {
      title: 'Correcting the subject of a photo',
      text: `“${panels.breakFrame}”, styles for only the subject or the background, and text that avoids bodies use the detected subject. If it is wrong, open “${brush.correct}” among the tools of a panel, or the brush on a photo that you clicked in the list. Paint to add to the subject, erase the rest, or select another subject. “${brush.found}” restores the detected subject.`,
    },
    styles: {
      title: 'Styles',
      text: `Every style is shown on one of your photos. Search styles by name, or choose a family; your favourites and recent styles come first. “${designer.styleShuffle}” sets which styles “${board.shuffle}” uses.`,
    },
    designer: {
      title: 'Making a style: the designer',
      text: `A style has two layers, one for colours and one for lines. Each layer is a list of blocks. “${designer.addBlock}” adds a block, its sliders change it, and “${designer.compare}” shows the result. Drag a block to move it, or insert one with the plus between two cards. “${designer.saveStyle}” adds the style to “${designer.myStyles}”.`,
    },
    explorer: {
      title: 'Finding a style: the explorer',
      text: `The explorer opens with random styles on your photo, and “${designer.generate}” makes more. Click a style to see it large. Mark styles with the heart, combine two with “${designer.breed}”, and apply one to the page with “${designer.useStyle}”. You can change any of them in the designer.`,
    },
    imitation: {
      title: 'A style from a picture',
      text: `“${imitation.styleFromPicture}” applies the look of a comic page, a print or a painting to your photos. Choose the picture there, or hold Alt and drop it anywhere. After a few seconds you see three to six styles on your photo; use one, save it, or change it in the designer.`,
    },
    words: {
      title: 'Captions, balloons and sound effects',
      text: `In “${side.sideTab.words}” you add a caption, a balloon or a sound effect. Inkpanel places it away from faces if there is room. Drag it to move it, and double-click it to write in it; on a touch screen, tap it a second time. “${words.addSubtitles}” reads the subtitle file of a video.`,
    },
    alike: {
      title: 'Similar photos, and excluded photos',
      text: `Inkpanel uses the sharpest of several similar photos and excludes the others. It also excludes blurred photos. You find them under “${photos.setAside}”: tick one to use it. Set how similar photos must be under “${photos.choice}”.`,
    },
    pages: {
      title: 'Several pages',
      text: `“${book.add}” adds a page with photos that no page shows yet. “${book.spreadAlbum}” puts all photos on as many pages as they need. You can move and remove pages, and apply one style to all of them.`,
    },
    paper: {
      title: 'Page size and margins',
      text: `The page settings have the page size (A4 and others, or custom), the margin, the gutter between the panels, the borders, the round corners and the colours. They are the same for all pages.`,
    },
    saving: {
      title: 'Saving',
      text: `Your work is saved automatically in this browser, on this device. You find it here when you come back. “${storage.projects}” lists all projects by name. Clearing the data of this browser deletes them, so save the work that you love as a file, too.`,
    },
    files: {
      title: 'Project files',
      text: `In “${storage.projects}”, “${storage.saveProject}” saves the whole project as one file, with your photos at full size. Drop the file on this window or on another device to continue. A PNG of a page with project data opens in the same way. It finds its photos on this device, or it includes them if you chose “${pngStrings.cargoKind.photos}”.`,
    },
    export: {
      title: 'Export: PNG, JPEG, WebP, PDF',
      text: `“${board.download}” saves the page at print size, from your original photos. “${board.export}” offers JPEG, WebP and PDF, and the quality. Several pages become a PDF, a ZIP or a CBZ for comic readers.`,
    },
    comics: {
      title: 'Comics for reading: HTML, EPUB, CBZ',
      text: `“${board.export}” also makes comics. “HTML comic” is one file that opens in any browser: tap, swipe or press the arrow keys to go from panel to panel, see whole pages, or read everything as text. EPUB is for reading apps, CBZ for comic readers. All of them store the order of the panels, the text of each panel and the detected subjects, so that they can be read aloud.`,
    },
    privacy: {
      title: 'Offline and private',
      text: `Your photos never leave this device: all work is done in this browser, and nothing is sent anywhere. Inkpanel locates faces so that panels do not cut them, and recognises nobody. The location in a photo is read only to name its place in captions, with a table of GeoNames (CC BY 4.0); exported pages never contain it. After the first visit Inkpanel also works offline. If the browser supports it, “${offlineStrings.install}” opens Inkpanel in a separate window.`,
    },
    keyboard: {
      title: 'Keyboard',
      text: `Everything works without a mouse; the shortcuts are listed below. Arrow keys go from panel to panel. Enter selects the photo of a panel, and arrow keys then move it. If you control your computer by voice, you can turn off single-letter shortcuts.`,
    },
  },
};
