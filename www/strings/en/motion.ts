/** Strings of motion comics: the pages as a video, panel by panel. */

export const motionStrings = {
  motion: {
    help: 'Plays the pages as a motion comic: first the whole page, then panel by panel. Dialogue appears as it is read.',
    seconds: 'Seconds per panel',
    change: 'Page transition',
    preview: 'Motion comic',
    living: 'Animate panels with video frames',
    larger: 'Each animated panel adds up to two megabytes to the file.',
    apart: 'Panels are not animated, because the style draws subjects separately.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} of ${of}, page ${page}, panel ${panel}` : `${time} of ${of}, page ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 page' : `${pages} pages`}, ${length} at ${fps} frames per second`,
    planning: 'planning the pages…',
    failed: (why: string) => `The motion comic could not be created: ${why}`,
    making: (percent: string) => `Creating the motion comic, ${percent}`,
    saved: 'The motion comic was saved.',
  },
};
