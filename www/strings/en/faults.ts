/** What went wrong, and a way on. */

export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}: ${why}`,
  filesFailed: (n: number) => `${n} files could not be read.`,
  importBroken: (why: string) => `reading it failed with an internal error: ${why}`,
  showList: 'Show the list',
  moreFiles: (n: number) => `and ${n} more`,
  /** Reasons in the page's words where it knows better than the core, by error code. */
  reasons: {
    'animatic-encoder': 'the browser stopped encoding it. Choose a smaller size or another kind of file.',
    'animatic-long': 'a GIF file is for up to a minute. Choose MP4 or WebM, or shorter shots.',
    'animatic-sound': 'this browser encodes no sound for such a file. Choose WebM, or leave the sound out.',
    'sound-unread': 'the browser cannot read the sound. Convert it to MP3 or WAV.',
    'film-cut':
      'it breaks off before the list of its frames, so that nothing of it can be read. Copy or record it again.',
    'film-empty': 'there is no frame in it.',
    'films-missing': 'what reads films could not be loaded. Try again with a connection.',
    'worker-lost': 'reading it stopped the program twice, so it was left out.',
    'unreadable-file': 'the file was moved, changed or deleted since you chose it.',
    'not-text': 'it is not a text file, or its encoding is unknown. Save it as UTF-8.',
    'unreadable-entry': 'the browser cannot read it. It may be stored online only, or be a broken link.',
    'unreadable-folder': 'the browser cannot read all files of this folder.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n === 1 ? '1 file was' : `${n} files were`} left out: a project holds ${most} photos.`,
  /** The same where the reason is what the file is. */
  reasonsOf: {
    'film-container': (what: string) =>
      `it is a film in ${what}, which cannot be read here. Convert it to MP4 with H.264 video, with HandBrake or ffmpeg for example.`,
    'film-codec': (what: string) =>
      `its pictures are ${what}, which this browser cannot decode. Convert it to MP4 with H.264 video, with HandBrake or ffmpeg for example.`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) => `${name}: ${share} of the picture is damaged and drawn grey.`,
  photoCoarse: (name: string, share: string) =>
    `${name}: ${share} of the picture lacks detail, because the file is damaged or incomplete.`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name} is broken off: only to ${till} of ${whole}. The frames are from there.`,
  noUsablePhoto:
    'None of these files could be used. Choose JPEG, PNG, WebP, AVIF, GIF, BMP or TIFF photos, or a video.',
  noSamples: 'The sample album could not be loaded. Check the connection and try again.',
  noPhotosInUse: 'No photo is in use. Tick one in Photos to get a page.',
  panelFailed: (why: string) => `A panel could not be drawn: ${why}`,
  notDone: (why: string) => `This could not be done: ${why}`,
  coreFailed: (why: string) => `Inkpanel could not start: ${why}`,
  locked: { layout: 'The layout is locked.', style: 'The style is locked.', photos: 'The photos are locked.' },
};
