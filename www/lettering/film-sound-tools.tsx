/** Sounds of the imported videos: a button for each video starts the detection, and a list offers sound effects. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import type { Video } from '../document/album.ts';
import type { Proposal } from './film-sounds.ts';

export function FilmSoundTools() {
  const { store } = useApp();
  const films = store.films.value.filter(({ duration }) => duration !== null);
  return films.map((video) => (
    <div key={video.key} class="film-sounds" role="group" aria-label={video.name}>
      {films.length > 1 && <p class="film-name">{video.name}</p>}
      <FilmSounds video={video} />
    </div>
  ));
}

function FilmSounds({ video }: { video: Video }) {
  const { filmSounds } = useApp();
  const says = strings.filmSounds;
  const heard = filmSounds.of(video);
  const stage = heard && 'stage' in heard ? heard.stage : undefined;
  const events = heard && 'events' in heard ? heard.events : undefined;
  const found = events && filmSounds.proposals(video, events);
  const hear = {
    label: says.hear,
    icon: 'effect',
    why: stage === undefined ? '' : says[stage],
    run: () => void filmSounds.hear(video),
  };
  return (
    <>
      {/* The button stays in place during detection, so that it keeps the keyboard focus. */}
      <ActionButton action={hear} class="button small" text tells />
      {stage && (
        <div class="reading">
          <progress class="progress" aria-label={says[stage]} />
          <IconButton icon="close" label={says.stop} onClick={() => filmSounds.stop(video)} />
        </div>
      )}
      <p class="quiet" role="status">
        {stage && says[stage]}
        {heard && 'why' in heard && heard.why}
        {found && counted(found, events.length)}
      </p>
      {found && found.near.length > 0 && <List video={video} near={found.near} />}
    </>
  );
}

/** @param all total number of sounds */
function counted({ near, far }: { near: readonly Proposal[]; far: number }, all: number) {
  const says = strings.filmSounds;
  if (all === 0) return says.silent;
  return [near.length > 0 ? says.near({ n: near.length }) : says.none, ...(far > 0 ? [says.far({ n: far })] : [])].join(
    ' ',
  );
}

function List({ video, near }: { video: Video; near: readonly Proposal[] }) {
  const { filmSounds } = useApp();
  return (
    <ul class="sound-list" aria-label={strings.filmSounds.of({ name: video.name })}>
      {near.map((proposal) => {
        const time = strings.clock(proposal.event.start);
        return (
          <li key={proposal.cue}>
            <span class="sound-time">{time}</span>
            {proposal.taken !== undefined && <span class="sound-taken">{strings.filmSounds.there}</span>}
            <span class="sound-words">
              {proposal.event.words.map((word) => {
                const text = strings.soundWords[word];
                return (
                  <button
                    key={word}
                    type="button"
                    class="button small"
                    aria-label={strings.filmSounds.put({ text, time })}
                    aria-pressed={proposal.taken === text}
                    aria-disabled={proposal.taken !== undefined}
                    onClick={() => {
                      if (proposal.taken === undefined) void filmSounds.take(proposal, word);
                    }}
                  >
                    {text}
                  </button>
                );
              })}
            </span>
          </li>
        );
      })}
    </ul>
  );
}
