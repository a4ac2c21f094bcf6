// @ts-check
/** Words of photos and videos, and of what is found in them. */

export const photoStrings = {
  photos: 'Photos',
  usePhoto: (/** @type {string} */ name) => `Use ${name}`,
  removePhoto: (/** @type {string} */ name) => `Remove ${name}`,
  photoMissing: 'Missing',
  addPhotos: 'Add photos',
  kept: 'On the table',
  setAside: 'Set aside',
  choice: 'Choice of photos',
  alike: 'Set aside look-alikes',
  alikeValue: (/** @type {number} */ bits) => (
    bits < 7 ? `${bits}, nearly identical` : bits < 11 ? `${bits}, the same picture` : bits < 14 ? `${bits}, much alike` : `${bits}, somewhat alike`
  ),
  alikeKept: (/** @type {number} */ kept, /** @type {number} */ all) => `${kept} of ${all} kept`,
  order: 'Order',
  orders: { time: 'By time taken', name: 'By file name' },
  stackOf: (/** @type {number} */ count) => `${count} alike`,
  openStack: (/** @type {number} */ count, /** @type {string} */ name) => `Show the ${count} photos like ${name}`,
  take: 'Take',
  takeInstead: (/** @type {string} */ name) => `Take ${name} instead`,
  /** @param {{ title: string, author: string, licence: string }} sample */
  credit: ({ title, author, licence }) => `${title}, by ${author} (${licence})`,
  photoCount: (/** @type {number} */ used, /** @type {number} */ all) => (used === all ? `${all}` : `${used} of ${all}`),
  reading: (/** @type {number} */ done, /** @type {number} */ total) => `Reading photos, ${done} of ${total}`,
  cancelReading: 'Stop reading',

  // Videos
  videos: 'Videos',
  videoFrames: (/** @type {number} */ count) => (count === 1 ? '1 frame' : `${count} frames`),
  trimStart: 'Start',
  trimEnd: 'End',
  frames: 'Frames',
  takeFrames: 'Take these frames',

  showSubjects: 'Show subjects',
  finding: (/** @type {number} */ done, /** @type {number} */ total) => `Faces ${done}/${total}`,
  findingLong: (/** @type {number} */ done, /** @type {number} */ total) => `Looking for faces and objects: ${done} of ${total} photos`,
  noDetector: 'Faces cannot be found here, so photos are cropped by contrast.',
};
