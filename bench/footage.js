// @ts-check
/** Long test videos: the camera moves over different parts of the sample photos, with hard cuts. */

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, renameSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [WIDTH, HEIGHT, RATE] = [854, 480, 24];
/** Shots until they are the same again, and their seconds. */
const [SHOTS, SECONDS] = [120, 5];

/**
 * Makes a video with ffmpeg, if it does not exist: ten minutes, repeated up to the requested length.
 * @param {string} album folder of photos
 * @param {string} folder for the videos
 * @param {number} minutes
 * @returns {string} path of an MP4 file, 854 x 480, 24 frames per second, H.264 and a tone
 */
export function makeFilm(album, folder, minutes) {
  mkdirSync(folder, { recursive: true });
  const film = join(folder, `film-${minutes}.mp4`);
  if (existsSync(film)) return film;
  const photos = readdirSync(album).filter((name) => name.endsWith('.jpg'));
  const shots = Array.from({ length: SHOTS }, (_, i) => {
    const shot = join(folder, `shot-${i}.mp4`);
    if (!existsSync(shot)) makeShot(join(album, photos[i % photos.length]), i, shot);
    return shot;
  });
  const list = join(folder, 'shots.txt');
  writeFileSync(list, shots.map((shot) => `file '${shot}'\n`).join(''));
  const loops = Math.ceil((minutes * 60) / (SHOTS * SECONDS)) - 1;
  // Written under another name until it is complete.
  const half = join(folder, 'half.mp4');
  const input = ['-stream_loop', String(loops), '-f', 'concat', '-safe', '0', '-i', list];
  ffmpeg([...input, '-t', String(minutes * 60), '-c', 'copy', half]);
  renameSync(half, film);
  return film;
}

/** @param {string} photo @param {number} i @param {string} path */
function makeShot(photo, i, path) {
  // A window of half the photo that starts at one of nine positions and moves slowly.
  const [across, down] = [(i % 3) / 4, (Math.floor(i / 3) % 3) / 4];
  const [wide, high] = [WIDTH * 2, HEIGHT * 2];
  const moved = (/** @type {string} */ side, /** @type {number} */ from) =>
    `${side}*(${from}+0.04*t)*${i % 2 === 0 ? 1 : '(1-0.01*t)'}`;
  const graph =
    `scale=${wide}:${high}:force_original_aspect_ratio=increase,crop=${wide}:${high},fps=${RATE},` +
    `crop=${WIDTH}:${HEIGHT}:${moved(String(WIDTH), across)}:${moved(String(HEIGHT), down)},format=yuv420p`;
  const picture = ['-loop', '1', '-t', String(SECONDS), '-i', photo];
  const tone = ['-f', 'lavfi', '-t', String(SECONDS), '-i', `sine=frequency=${220 + 10 * i}:sample_rate=48000`];
  const coded = ['-c:v', 'libx264', '-preset', 'veryfast', '-crf', '23', '-c:a', 'aac', '-b:a', '96k'];
  ffmpeg([...picture, ...tone, '-vf', graph, ...coded, '-shortest', path]);
}

/** @param {string[]} args */
function ffmpeg(args) {
  execFileSync('ffmpeg', ['-v', 'error', '-y', ...args]);
}
