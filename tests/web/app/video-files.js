// @ts-check
/** Content of video files. */

import { execFile } from 'node:child_process';
import { promisify } from 'node:util';

const run = promisify(execFile);

/**
 * Returns streams and warnings of a file, by ffprobe.
 * @param {string} path
 * @returns {Promise<any>} `streams`, with their frames counted, `format`, and `complaints`
 */
export async function probed(path) {
  const asked = ['-v', 'warning', '-count_frames', '-show_streams', '-show_format', '-of', 'json', path];
  const { stdout, stderr } = await run('ffprobe', asked);
  return { ...JSON.parse(stdout), complaints: stderr };
}
