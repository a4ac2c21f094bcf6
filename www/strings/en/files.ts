/** Strings of files with an embedded project, and of archives. */

export const fileStrings = {
  cargoFile: 'Inside the file',
  cargoFileHelp: {
    project: 'Drop the file here to edit it again. It finds its photos on this device.',
    photos: 'Includes your original photos, so it opens on any device. Anyone with the file can see them.',
    none: 'Only the pages.',
  },
  packingPhotos: (percent: string) => `Adding the photos to the file, ${percent}`,
  photosTooLarge: 'together, the photos are too large for a PNG. Save the project as a file instead.',
  savingProject: (done: number, total: number) => `Saving the project, ${Math.floor(done)} of ${total} files`,
  damagedInArchive: (archive: string) => `it is damaged in ${archive}.`,
  noPicturesInside: 'it contains no images.',
  unknownJson: 'it is not an Inkpanel layout or style.',
  filesSkipped: (n: number) =>
    n === 1
      ? '1 file that a system or program stores next to photos was skipped.'
      : `${n} files that systems and programs store next to photos were skipped.`,
  /** `remedy`: a request to the user */
  unsupportedKind: (name: string, remedy: string) => `this kind of file (${name}) cannot be read. ${remedy}`,
  remedies: {
    jpeg: 'Save it as JPEG in a program that opens it.',
    unpack: 'Unpack it and add its pictures, or pack them as ZIP.',
    pages: 'Save its pages as PNG or JPEG.',
    mp4: 'Convert it to MP4 with H.264 video.',
    srt: 'Convert it to SRT or WebVTT.',
    fountain: 'Export it as Fountain.',
    csv: 'Save it as CSV.',
    text: 'Save it as plain text.',
  },
  boardFile: 'it is a screenplay or a table. Open the storyboard and choose “Import script or table”.',
  liveVideos: (n: number) =>
    n === 1
      ? '1 video of a Live Photo was not added. Its photo was.'
      : `${n} videos of Live Photos were not added. Their photos were.`,
  addLiveVideos: (n: number): string => (n === 1 ? 'Add the video' : 'Add the videos'),
};
