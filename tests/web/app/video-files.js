// @ts-check
/** What is in a file of a film. */

import { execFile } from 'node:child_process';
import { promisify } from 'node:util';

const run = promisify(execFile);

/**
 * What ffprobe finds in a file, and what it complains of.
 * @param {string} path
 * @returns {Promise<any>} `streams`, with their frames counted, `format`, and `complaints`
 */
export async function probed(path) {
  const asked = ['-v', 'warning', '-count_frames', '-show_streams', '-show_format', '-of', 'json', path];
  const { stdout, stderr } = await run('ffprobe', asked);
  return { ...JSON.parse(stdout), complaints: stderr };
}
