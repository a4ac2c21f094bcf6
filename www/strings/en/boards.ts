/** Words of boards: the list of shots, the sheets, the ways out and in. */

export const boardsStrings = {
  boards: {
    seen: 'View',
    comic: 'Comic',
    board: 'Storyboard',
    sheets: 'Storyboard sheets',
    shots: 'Shots',
    picture: 'Picture',
    order: 'Order',
    columns: {
      scene: 'Scene',
      number: 'Shot',
      length: 'Length',
      action: 'Action',
      dialogue: 'Dialogue',
      notes: 'Notes',
    },
    /** the columns of a list that is saved */
    heading: ['Scene', 'Shot', 'Picture', 'Film', 'Time code', 'Duration', 'Frames', 'Action', 'Dialogue', 'Notes'],
    /** on the sheets; `{page}` and `{count}` become numbers */
    labels: { scene: 'Scene', dialogue: 'Dialogue', notes: 'Notes', page: 'Page {page} of {count}' },
    count: (count: number) => (count === 1 ? '1 shot' : `${count} shots`),
    shot: (number: string) => `shot ${number}`,
    up: (number: string) => `Move shot ${number} up`,
    down: (number: string) => `Move shot ${number} down`,
    help: 'Enter goes to the next shot, Tab to the next field, Escape gives up what was typed. Alt with the arrow keys moves a shot. Lengths are seconds (2), seconds and frames (2:12) or frames (36f). Cells of a spreadsheet can be pasted.',
    dragHelp: 'Drag to put it elsewhere.',
    copy: 'Copy the list',
    copied: 'The list is on the clipboard, for a spreadsheet.',
    newColumn: 'New column',
    addColumn: 'Add column',
    removeColumn: (name: string) => `Remove column ${name}`,
    noLength: (text: string) => `“${text}” is no length: write seconds (2), seconds and frames (2:12) or frames (36f).`,
    pasteLost: (count: number) =>
      count === 1 ? '1 pasted cell found no place.' : `${count} pasted cells found no place.`,
    filmBoard: 'Film board',
    perSheet: 'Frames a sheet',
    aspect: 'Aspect',
    rate: 'Frames a second',
    beside: 'Text beside the frames',
    ruled: 'Worksheet: lines to write on',
    author: 'By',
    date: 'Date',
    logo: 'Logo',
    chooseLogo: 'Choose a logo',
    removeLogo: 'Remove the logo',
    logoFile: 'Picture for the logo',
    noLogo: (name: string) => `${name} is no picture that the browser can show. Choose a PNG, JPEG, WebP or SVG file.`,
    brokenLogo: 'The logo cannot be read. Remove it, or choose another.',
    saveAs: 'Save as',
    saveBoard: 'Save board',
    ways: { pdf: 'Board, PDF', zip: 'Board, PNG files in a ZIP' },
    importFile: 'Import script or table',
    tooLarge: (name: string) => `${name} is too large for a script or a table.`,
    nothingIn: (name: string) => `Nothing in ${name} fits the shots.`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name}: 1 shot was filled in.` : `${name}: ${count} shots were filled in.`,
    quoted: (text: string) => `“${text}”`,
    left: (count: number, lines: string) =>
      count === 1 ? `1 line found no shot: ${lines}.` : `${count} lines found no shot: ${lines}.`,
    cellsLeft: (count: number, cells: string) =>
      count === 1
        ? `1 cell was left out or shortened: ${cells}.`
        : `${count} cells were left out or shortened: ${cells}.`,
    columnsLeft: (columns: string) => `The board has no room for these columns: ${columns}.`,
    noSheets: (why: string) => `The board could not be laid out: ${why}`,
    missing: 'The part of the program that shows boards could not be loaded. Try again.',
    sheet: (n: number, of: number) => `Sheet ${n} of ${of}`,
    listSaved: 'The shot list was saved.',
    listHelp: 'All shots of the album with what is told of them, in the order of the board.',
  },
};
