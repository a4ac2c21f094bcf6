/** Words of photos and videos, and of what is found in them. */

export const photoStrings = {
  photos: 'Photos',
  usePhoto: (name: string) => `Use ${name}`,
  pickPhoto: (name: string) => `Choose ${name}`,
  pickLong: 'Click to put it in the chosen panel, or in the one that is clicked next; drag it onto a panel',
  onPanel: (panel: number) => `${panel}`,
  onPageAndPanel: (page: number, panel: number) => `${page} · ${panel}`,
  onPanelLong: (page: number | null, panel: number) =>
    page === null ? `on panel ${panel}` : `on page ${page}, panel ${panel}`,
  youLeftOut: 'You left it out',
  leftOut: (name: string) => `${name} is left out.`,
  starPhoto: (name: string) => `Star ${name}`,
  starLong: 'Show it large, here and in every shuffle',
  removePhoto: (name: string) => `Remove ${name}`,
  photoMissing: 'Missing',
  addPhotos: 'Add photos',
  kept: 'On the table',
  setAside: 'Set aside',
  setAsideWhy: 'Look-alikes and blurred photos. Tick one to use it.',
  choice: 'Choice of photos',
  alike: 'Set aside look-alikes',
  alikeValue: (bits: number) =>
    bits < 7
      ? `${bits}, nearly identical`
      : bits < 11
        ? `${bits}, the same picture`
        : bits < 14
          ? `${bits}, much alike`
          : `${bits}, somewhat alike`,
  alikeKept: (kept: number, all: number) => `${kept} of ${all} kept`,
  order: 'Order',
  orders: { time: 'By time taken', name: 'By file name' },
  stackWhy: 'They look alike. The ticked one is used; tick more, or take another.',
  stackOf: (count: number) => `${count} alike`,
  openStack: (count: number, name: string) => `Show the ${count} photos like ${name}`,
  take: 'Take',
  takeInstead: (name: string) => `Take ${name} instead`,
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
  frames: 'Frames from the film',
  lookingThrough: (name: string, percent: string) => `Looking through ${name}, ${percent}`,
  takeFrames: 'Take these frames',

  showSubjects: 'Show subjects',
  finding: (done: number, total: number) => `Looking for faces and objects: ${done} of ${total} photos`,
  masking: (done: number, total: number) => `Looking for figures: ${done} of ${total} photos`,
  stopMasking: 'Stop looking for figures',
  goOnMasking: 'Go on looking for figures',
  noDetector: 'Faces cannot be found here, so photos are cropped by contrast.',
};
