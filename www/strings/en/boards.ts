/** Strings of the storyboard: shot list, sheets, import and export. */

export const boardsStrings = {
  boards: {
    seen: 'View',
    comic: 'Comic',
    board: 'Storyboard',
    sheets: 'Storyboard sheets',
    shots: 'Shots',
    picture: 'Frame',
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
    help: 'Enter moves to the next shot, Tab to the next field. Escape discards the text that you typed. Alt with an arrow key moves the shot. Enter a length as seconds (2), seconds and frames (2:12) or frames (36f). You can paste cells from a spreadsheet.',
    followPages: 'Use the page order',
    dragHelp: 'Drag to move.',
    copy: 'Copy table',
    copied: 'The list was copied. You can paste it into a spreadsheet.',
    newColumn: 'New column',
    addColumn: 'Add column',
    removeColumn: (name: string) => `Remove column ${name}`,
    noLength: (text: string) =>
      `“${text}” is not a valid length. Use seconds (2), seconds and frames (2:12) or frames (36f).`,
    pasteLost: (count: number) =>
      count === 1
        ? '1 pasted cell was outside the table and was ignored.'
        : `${count} pasted cells were outside the table and were ignored.`,
    filmBoard: 'Film storyboard',
    perSheet: 'Frames per sheet',
    aspect: 'Aspect',
    rate: 'Frames per second',
    beside: 'Text next to the frames',
    ruled: 'Worksheet: lines for handwriting',
    author: 'By',
    date: 'Date',
    logo: 'Logo',
    chooseLogo: 'Choose a logo',
    removeLogo: 'Remove the logo',
    logoFile: 'Image for the logo',
    noLogo: (name: string) =>
      `${name} is not an image that this browser can show. Choose a PNG, JPEG, WebP or SVG file.`,
    brokenLogo: 'The logo cannot be read. Remove it, or choose another.',
    saveAs: 'Save as',
    saveBoard: 'Save storyboard',
    ways: { pdf: 'Storyboard, PDF', zip: 'Storyboard, PNG files in a ZIP' },
    importFile: 'Import script or table',
    tooLarge: (name: string) => `${name} is too large for a script or a table.`,
    nothingIn: (name: string) => `Nothing in ${name} matches the shots.`,
    taken: (count: number, name: string) =>
      count === 1 ? `${name}: 1 shot was filled in.` : `${name}: ${count} shots were filled in.`,
    quoted: (text: string) => `“${text}”`,
    left: (count: number, lines: string) =>
      count === 1 ? `1 line did not match any shot: ${lines}.` : `${count} lines did not match any shot: ${lines}.`,
    cellsLeft: (count: number, cells: string) =>
      count === 1
        ? `1 cell was skipped or shortened: ${cells}.`
        : `${count} cells were skipped or shortened: ${cells}.`,
    columnsLeft: (columns: string) => `The storyboard has no room for these columns: ${columns}.`,
    noSheets: (why: string) => `The storyboard could not be laid out: ${why}`,
    missing: 'The storyboard could not be loaded. Check your connection and try again.',
    sheet: (n: number, of: number) => `Sheet ${n} of ${of}`,
    listSaved: 'The shot list was saved.',
    listHelp: 'All shots of the album with their metadata, in storyboard order.',
  },
};
