import { expect, test } from 'vitest';
import { readAssetsFromFiles } from '../engine/testing-assets.ts';
import { momentsOf } from './cue-times.ts';

readAssetsFromFiles();

const film = new File([''], 'Trip.mp4', { type: 'video/mp4' });
const other = new File([''], 'a.webm', { type: 'video/webm' });
const cues =
  '1\r\n00:00:01,000 --> 00:00:03,000\r\nHello\r\n\r\n2\r\n01:00:00.5 --> 01:00:01.5 align:start\r\nThere\r\n';

test('the cues of subtitles are moments of the film of their name, else of the first', async () => {
  const moments = await momentsOf([other, film], [new File([cues], 'trip.en.srt')]);
  expect([...moments]).toEqual([[film, [2, 3601]]]);
  const loose = await momentsOf(
    [other],
    [new File(['02:30.000 --> 02:31.000\nx'], 'b.vtt'), new File(['A: hi'], 'c.txt')],
  );
  expect([...loose]).toEqual([[other, [150.5]]]);
  const wide = new File([Buffer.from(`\ufeff${cues}`, 'utf16le')], 'trip.srt');
  expect([...(await momentsOf([film], [wide]))]).toEqual([[film, [2, 3601]]]);
  expect((await momentsOf([], [new File([cues], 'x.srt')])).size).toBe(0);
});
