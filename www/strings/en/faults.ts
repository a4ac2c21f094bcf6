/** Error messages. Each says how to continue, if possible. */

export const faultStrings = {
  fileFailed: (name: string, why: string) => `${name}: ${why}`,
  filesFailed: (n: number) => `${n} files could not be read.`,
  internalError: (what: string) => `an internal error occurred: ${what}`,
  showList: 'Show the list',
  moreFiles: (n: number) => `and ${n} more`,
  /** Reasons by error code. They replace the message of the core. */
  reasons: {
    'animatic-encoder': 'the browser stopped encoding the video. Choose a smaller size or another format.',
    'animatic-long': 'a GIF file can be at most one minute long. Choose MP4 or WebM, or shorten the shots.',
    'animatic-sound': 'this browser cannot encode sound for this format. Choose WebM, or remove the soundtrack.',
    'sound-unread': 'the browser cannot read the sound. Convert it to MP3 or WAV.',
    'film-cut': 'the file is incomplete (its index is missing). Copy it again from the source.',
    'film-empty': 'the video has no frames.',
    'films-missing': 'the video reader could not be loaded. Check your connection and try again.',
    'texts-missing': 'the reader of text files could not be loaded. Check your connection and try again.',
    'worker-lost': 'Inkpanel crashed twice while reading it, so it was skipped.',
    'unreadable-file': 'the file was moved, changed or deleted since you chose it.',
    'not-text': 'it is not a text file, or its encoding is unknown. Save it as UTF-8.',
    'unreadable-entry': 'the browser cannot read it. It may be stored online only, or be a broken link.',
    'unreadable-folder': 'the browser cannot read all files of this folder.',
  } as Record<string, string>,
  tooManyPhotos: (n: number, most: string) =>
    `${n === 1 ? '1 file was' : `${n} files were`} skipped: a project can have at most ${most} photos.`,
  /** Reasons by error code that name the kind of file. */
  reasonsOf: {
    'film-container': (what: string) =>
      `Inkpanel cannot read this video format (${what}). Convert it to MP4 with H.264 video, with HandBrake or ffmpeg for example.`,
    'film-codec': (what: string) =>
      `this browser cannot decode ${what} video. Convert it to MP4 with H.264 video, with HandBrake or ffmpeg for example.`,
  } as Record<string, (what: string) => string>,
  photoDamaged: (name: string, share: string) => `${name}: ${share} of the photo is damaged and shown in grey.`,
  photoCoarse: (name: string, share: string) =>
    `${name}: ${share} of the photo lacks detail, because the file is damaged or incomplete.`,
  filmReaches: (name: string, till: string, whole: string) =>
    `${name} is incomplete: it ends at ${till} of ${whole}. All frames are from this part.`,
  noUsablePhoto:
    'None of these files could be used. Choose JPEG, PNG, WebP, AVIF, GIF, BMP or TIFF photos, or a video.',
  noSamples: 'The sample album could not be loaded. Check the connection and try again.',
  noPhotosInUse: 'No photo is in use. Tick one in Photos to get a page.',
  panelFailed: (why: string) => `A panel could not be drawn: ${why}`,
  partMissing: 'This part of Inkpanel could not be loaded. Check your connection and try again.',
  notDone: (why: string) => `This could not be done: ${why}`,
  coreFailed: (why: string) => `Inkpanel could not start: ${why}`,
  locked: { layout: 'The layout is locked.', style: 'The style is locked.', photos: 'The photos are locked.' },
};
