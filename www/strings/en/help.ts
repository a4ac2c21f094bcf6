/** The help, and the hints at first use. Controls are called as they are called in their own places. */

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
  helpNone: (text: string) => `Nothing here about “${text}”. Another word may do it, or look through all topics.`,
  allTopics: 'Show all topics',
  hintsAgain: 'Show the hints again',
  hint: {
    shuffle: 'Shuffle until you like it. Every page you have seen can be brought back.',
    crop: 'Drag to move the picture, scroll to zoom.',
    cropTouch: 'Drag to move the picture, pinch to zoom.',
    lock: 'Lock what you want to keep. The rest goes on changing.',
  },
  closeHint: 'Close the hint',
  topics: {
    adding: {
      title: 'Adding photos and films',
      text: `Drop photos or films anywhere on the window, paste them, or press “${photos.addPhotos}”. To have a look first, take “${startStrings.trySamples}”. More can be added at any time.`,
    },
    films: {
      title: 'Frames of a film',
      text: `Of a film Inkpanel takes some frames, which are then photos like any others. Press its name in the list of photos to say where it starts and ends and how many frames you want; “${photos.takeFrames}” takes them. A panel that shows a frame can go to an earlier or a later one. “${sounds.hear}”, under “${side.sideTab.words}”, proposes sound effects for what is heard near the frames on your pages.`,
    },
    shuffle: {
      title: 'Shuffling',
      text: `“${board.shuffle}” makes a new page of your photos, with another layout and another style. Beside it, “${board.part.layout}”, “${board.part.style}” and “${board.part.photos}” change that part alone. On a phone you can also swipe the page to the side.`,
    },
    locks: {
      title: 'Locking what should stay',
      text: `The lock beside “${board.part.layout}”, “${board.part.style}” or “${board.part.photos}” keeps it while you shuffle the rest. “${panels.lockPanel}” keeps the photo of one panel, as it is cropped. A photo with a star is shown large, here and in every shuffle.`,
    },
    versions: {
      title: 'Going back, and favourite pages',
      text: `“${board.undo}” and “${board.redo}” go through everything you did. “${board.previous}” and “${board.next}” go through the pages you have seen, and the number between them shows them all. The heart marks a page as a favourite.`,
    },
    ideas: {
      title: 'More ideas',
      text: `The strip below the page, “${side.moreIdeas}”, shows other pages of the same photos. A click takes one of them. Point at one to see it large.`,
    },
    layouts: {
      title: 'Layouts',
      text: `Choose a layout by its family and its number of panels; “${side.surprise}” invents one. With “${side.editLayout}” you drag the cuts between the panels, slant them, and split or remove panels. “${side.saveLayout}” saves it as a file and puts it in “${side.myLayouts}”.`,
    },
    joining: {
      title: 'Joining panels, and one photo across panels',
      text: `Turn on “${panels.selectPanels}” and choose panels that touch. “${panels.joinPanels}” makes one panel of them, where together they have the shape of one. “${panels.merge}” keeps the panels and lets one picture run through all of them; “${panels.split}” parts them again.`,
    },
    crop: {
      title: 'Moving and zooming a picture',
      text: `Drag the picture in its panel to move it, and turn the wheel or pinch to zoom. By touch, tap the panel first. A double click fits what the picture is about. “${panels.resetCrop}” takes it back to what the page would choose.`,
    },
    exchange: {
      title: 'Exchanging photos',
      text: `Drag a picture out of its panel onto another one, and the two change places; “${panels.swapPhoto}” does the same by clicks. Click a photo in the list, then a panel, and the photo goes there. Untick a photo in the list to leave it out.`,
    },
    subject: {
      title: 'Correcting what the subject is',
      text: `“${panels.breakFrame}”, styles for the subject or the background alone, and words that keep off bodies go by what was found in a photo. Where that is wrong, “${brush.correct}” among the tools of a panel opens it, or the brush on a photo of the list that you have clicked: paint what belongs to the subject, paint away what does not, or choose another subject. “${brush.found}” goes back to what was found.`,
    },
    styles: {
      title: 'Styles',
      text: `Every style is shown on a photo of yours. Search them by name, or choose a kind; your favourites and the last ones used come first. “${designer.styleShuffle}” says what “${board.shuffle}” draws from.`,
    },
    designer: {
      title: 'Making a style: the designer',
      text: `A style has two layers, one for the colours and one for the lines, and each is a row of blocks. “${designer.addBlock}” adds one, its sliders change it, and “${designer.compare}” shows what was done. Drag a block to its place, or put it in with the plus between two cards. “${designer.saveStyle}” puts it in “${designer.myStyles}”.`,
    },
    explorer: {
      title: 'Finding a style: the explorer',
      text: `It opens with styles invented on your own photo, and “${designer.generate}” makes more. A click shows one large. Keep those you like with the heart, make more of two with “${designer.breed}”, and put one on the page with “${designer.useStyle}”. Any of them can be changed in the designer.`,
    },
    imitation: {
      title: 'A style from a picture',
      text: `“${imitation.styleFromPicture}” takes the look of a comic page, a print or a painting over to your photos. Choose the picture there, or drop it anywhere with Alt held. After a few seconds you see three to six styles on your own photo; use one, save it, or change it in the designer.`,
    },
    words: {
      title: 'Captions, balloons and sound effects',
      text: `In “${side.sideTab.words}” you add a caption, a balloon or a sound effect; it is put where it hides no face, if there is room. Drag it, or write in it by a double click; by touch, tap it once more. Films bring words, too: “${words.addSubtitles}” reads a file of subtitles.`,
    },
    alike: {
      title: 'Look-alikes, and what is set aside',
      text: `Of photos that look alike the sharpest is used and the others are set aside, as are blurred ones. They are under “${photos.setAside}”: tick one to use it. How alike they must be you say under “${photos.choice}”.`,
    },
    pages: {
      title: 'Several pages',
      text: `“${book.add}” adds a page to the storyboard, made of photos that no page shows yet, as long as there are some. “${book.spreadAlbum}” puts all photos on as many pages as they need. Pages can be moved, removed, and given one style.`,
    },
    paper: {
      title: 'Page size and margins',
      text: `The settings of the page have its size, from A4 to sizes of your own, the margin, the gutter between the panels, the borders, the round corners and the colours. They are the same for all pages of a storyboard.`,
    },
    saving: {
      title: 'Saving',
      text: `Your work is saved by itself in this browser, on this device, and is there again when you come back. “${storage.projects}” has all of it, each with its name. When you clear the data of this browser it is gone, so keep what you love as a file, too.`,
    },
    files: {
      title: 'Project files',
      text: `In “${storage.projects}”, “${storage.saveProject}” makes one file of all, with your photos at full size. Drop it on the window here or on another device to go on. A PNG of a page opens the same way; it finds its photos on this device, or has them in it where you chose “${pngStrings.cargoKind.photos}”.`,
    },
    export: {
      title: 'Export: PNG, JPEG, WebP, PDF',
      text: `“${board.download}” saves the page at print size, from your original photos. “${board.export}” has JPEG, WebP and PDF, and the quality. Several pages become a PDF, a ZIP or a CBZ for comic readers.`,
    },
    comics: {
      title: 'Comics that are read: HTML, EPUB, CBZ',
      text: `“${board.export}” makes comics, too. “HTML comic” is one file that anybody can open in a browser: tap, swipe or press the arrows to go from panel to panel, see whole pages, or read all as text. EPUB is for reading apps, CBZ for comic readers. In all of them each panel is known in its order, with its words and, as far as it was found, what it shows; so they can be read aloud.`,
    },
    privacy: {
      title: 'Offline and private',
      text: `Your photos never leave this device: all the work is done in this browser, and nothing is sent anywhere. After the first visit Inkpanel also works without a connection. Where the browser can, “${offlineStrings.install}” gives it a window of its own.`,
    },
    keyboard: {
      title: 'By keyboard',
      text: `Everything can be done without a mouse; the shortcuts are listed below. Arrows go from panel to panel, Enter takes the picture of one, and arrows then move it. Single letters can be turned off as shortcuts, for those who speak to their computer.`,
    },
  },
};
