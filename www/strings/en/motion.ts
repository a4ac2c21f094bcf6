/** Words of motion pages: the pages as a film, read panel by panel. */

export const motionStrings = {
  motion: {
    help: 'The pages of the storyboard as a film: each is seen as a whole, then panel by panel, and what is said appears as it is read.',
    seconds: 'Seconds a panel',
    change: 'From page to page',
    preview: 'Motion page',
    living: 'Panels from films move',
    larger: 'A panel makes the file larger by up to two megabytes.',
    apart: 'Panels stay still: the style draws figures apart.',
    place: (time: string, of: string, page: string, panel: number) =>
      panel > 0 ? `${time} of ${of}, page ${page}, panel ${panel}` : `${time} of ${of}, page ${page}`,
    facts: (pages: number, length: string, fps: string) =>
      `${pages === 1 ? '1 page' : `${pages} pages`}, ${length} at ${fps} frames a second`,
    planning: 'laying the pages out…',
    failed: (why: string) => `The motion page cannot be laid out: ${why}`,
    making: (percent: string) => `Making the motion page, ${percent}`,
    saved: 'The motion page was saved.',
  },
};
