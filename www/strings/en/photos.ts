/** Strings of photos and videos, and of detection. */

export const photoStrings = {
  photos: 'Photos',
  usePhoto: (name: string) => `Use ${name}`,
  pickPhoto: (name: string) => `Choose ${name}`,
  pickLong:
    'Click to put it in the selected panel, or in the panel that you click next. You can also drag it onto a panel.',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `on panel ${panel}` : `on page ${page}, panel ${panel}`,
  youLeftOut: 'You excluded it',
  leftOut: (name: string) => `${name} was excluded.`,
  starPhoto: (name: string) => `Star ${name}`,
  starLong: 'Enlarge this photo’s panel, and show the photo large in every shuffle',
  starLocked: 'Photo starred. The layout or the panel is locked, so the panel keeps its size.',
  starKeepsSize: 'Photo starred. This layout has no space for a larger panel; Shuffle shows the photo large.',
  removePhoto: (name: string) => `Remove ${name}`,
  photoMissing: 'Missing',
  addPhotos: 'Add photos',
  kept: 'In use',
  unseen: {
    waits: 'Not shown yet',
    text: 'Not shown: it looks like a page of text',
    small: 'Not shown: too few pixels',
  },
  setAside: 'Excluded',
  setAsideWhy: 'Similar and blurred photos. Tick one to use it.',
  choice: 'Photo selection',
  alike: 'Exclude similar photos',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, nearly identical`
      : bits < 11
        ? `${bits}, the same scene`
        : bits < 14
          ? `${bits}, very similar`
          : `${bits}, somewhat similar`,
  alikeKept: (kept: number, all: number) => `${kept} of ${all} in use`,
  order: 'Order',
  orders: { time: 'By capture time', name: 'By file name' },
  stackWhy: 'These photos are similar. The ticked one is used. Tick more, or use another one.',
  stackOf: (count: number) => `${count} similar`,
  openStack: (count: number, name: string) => `Show the ${count} photos similar to ${name}`,
  take: 'Use',
  takeInstead: (name: string) => `Use ${name} instead`,
  credit: ({ title, author, licence }: { title: string; author: string; licence: string }) =>
    `${title}, by ${author} (${licence})`,
  photoCount: (used: number, all: number) => (used === all ? `${all}` : `${used} of ${all}`),
  reading: (done: number, total: number) => `Reading photos, ${done} of ${total}`,
  cancelReading: 'Stop reading',

  // Videos
  videos: 'Videos',
  videoFrames: (count: number) => (count === 1 ? '1 frame' : `${count} frames`),
  trimStart: 'Start',
  trimEnd: 'End',
  frames: 'Frames from the video',
  lookingThrough: (name: string, percent: string) => `Analysing ${name}, ${percent}`,
  takeFrames: 'Use these frames',

  showSubjects: 'Show subjects',
  finding: (done: number, total: number) => `Detecting faces and objects: ${done} of ${total} photos`,
  masking: (done: number, total: number) => `Detecting subjects: ${done} of ${total} photos`,
  stopMasking: 'Stop subject detection',
  goOnMasking: 'Resume subject detection',
  noDetector: 'Face detection is not available here, so photos are cropped by contrast.',
};
