/** The videos in the tray: number of frames, and the part of the video, which can be changed. */

import { useState } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import type { Video } from '../document/album.ts';

const MOST_FRAMES = 120;
/** The shortest stretch, in seconds. */
const SHORTEST = 0.1;

export function Videos() {
  const { store } = useApp();
  const videos = store.films.value;
  if (videos.length === 0) return null;
  return (
    <ul class="videos" aria-label={strings.videos}>
      {videos.map((video) => (
        <Trim key={video.key} video={video} />
      ))}
    </ul>
  );
}

function Trim({ video }: { video: Video }) {
  const { store, reading } = useApp();
  const { key, name, ids, duration } = video;
  const [wish, setWish] = useState({ start: video.start, end: video.end, frames: ids.length });
  if (duration === null) return null;
  const end = wish.end ?? duration;
  const set = (part: Partial<typeof wish>) => setWish({ ...wish, end, ...part });
  const takeFrames = {
    label: strings.takeFrames,
    enabled: store.reading.value === null,
    run: () => reading.resample(key, { start: wish.start, end, frames: wish.frames }),
  };
  return (
    <li class="video">
      <details>
        <summary>
          <span class="video-name">{name}</span>
          <span class="count">{strings.videoFrames({ count: ids.length })}</span>
        </summary>
        <Time
          label={strings.trimStart}
          value={wish.start}
          max={duration}
          onInput={(start) => set({ start: Math.min(start, end - SHORTEST) })}
        />
        <Time
          label={strings.trimEnd}
          value={end}
          max={duration}
          onInput={(value) => set({ end: Math.max(value, wish.start + SHORTEST) })}
        />
        <label class="field">
          <span>{strings.frames}</span>
          <input
            type="range"
            min="1"
            max={MOST_FRAMES}
            value={wish.frames}
            aria-valuetext={strings.videoFrames({ count: wish.frames })}
            onInput={({ currentTarget }) => set({ frames: currentTarget.valueAsNumber })}
          />
          <output aria-hidden="true">{wish.frames}</output>
        </label>
        <ActionButton action={takeFrames} class="button" text />
      </details>
    </li>
  );
}

function Time({
  label,
  value,
  max,
  onInput,
}: {
  label: string;
  value: number;
  max: number;
  onInput: (seconds: number) => void;
}) {
  return (
    <label class="field">
      <span>{label}</span>
      <input
        type="range"
        min="0"
        max={max}
        step="0.1"
        value={value}
        aria-valuetext={strings.clock(value)}
        onInput={({ currentTarget }) => onInput(currentTarget.valueAsNumber)}
      />
      <output aria-hidden="true">{strings.clock(value)}</output>
    </label>
  );
}
