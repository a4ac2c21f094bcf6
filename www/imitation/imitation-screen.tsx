/**
 * A style from a picture: the picture next to the user's photo in the selected style, and all found styles below them.
 */

import { useEffect, useMemo, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ChosenFiles } from '../photos/chosen-files.tsx';
import { PLAIN } from '../photos/cover.ts';
import { useHero } from '../photos/hero.ts';
import { PhotoPicker, useDrawnPhotos } from '../photos/photo-picker.tsx';
import { ActionButton } from '../ui/action-button.tsx';
import { Bitmap, screenPixels } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { Workspace } from '../ui/workspace.tsx';
import type { Style } from '../engine/types.ts';
import type { Shown } from '../photos/photo-picker.tsx';

/** Pictures of any kind that the engine reads. */
const PICTURES = 'image/*';
/** The long side of the result and of a proposal, in CSS pixels. */
const LARGE = 760;
const SMALL = 190;
/** The long side of the copy of a photo that is drawn from. */
const MOST = 1600;

export function ImitationScreen() {
  const { imitation, designer, actions } = useApp();
  const facts = useDrawnPhotos();
  const hero = useHero();
  const found = (id: string | null) => facts.find((fact) => fact.id === id);
  const fact = found(imitation.photo.value) ?? found(hero) ?? facts[0] ?? null;
  const picture = imitation.picture.value;
  const running = imitation.progress.value !== null;

  const subject = fact?.id;
  useEffect(() => (subject === undefined ? undefined : imitation.prepare(subject)), [subject]);
  // Analyses a new picture automatically. Closing the workspace cancels running work.
  useEffect(() => {
    if (picture && fact && imitation.proposals.peek().length === 0 && imitation.fault.peek() === null)
      void imitation.search(fact.id);
  }, [picture, fact === null]);
  useEffect(() => imitation.stop, []);

  const tools = (
    <div class="imitation-bar">
      {picture && <ChoosePicture strong={false} />}
      {picture && fact && !running && (
        <ActionButton
          action={{ label: strings.imitationAgain, icon: 'surprise', run: () => void imitation.search(fact.id) }}
          class="button"
          text
        />
      )}
    </div>
  );
  return (
    <Workspace title={strings.styleFromPicture} class="imitation" tools={tools} busy={running} onClose={designer.close}>
      {picture ? (
        <div class="imitation-body">
          <div class="imitation-pair">
            <Original />
            {fact && <Result fact={fact} />}
          </div>
          <Status fact={fact} />
          {fact && <Proposals fact={fact} />}
          <div class="imitation-tools">
            <ActionButton action={actions.imitation.save} class="button" text />
            <ActionButton action={actions.imitation.edit} class="button" text />
            <ActionButton action={actions.imitation.use} class="button strong" text />
          </div>
          {facts.length > 1 && (
            <PhotoPicker
              label={strings.imitationPhotos}
              facts={facts}
              chosen={fact?.id ?? null}
              told={(name) => strings.drawOn({ name })}
              onChoose={(id) => {
                imitation.photo.value = id;
              }}
            />
          )}
        </div>
      ) : (
        <div class="imitation-empty" data-drop="style">
          <Icon name="imitate" />
          <p>{strings.imitationAbout}</p>
          <ChoosePicture strong />
          <p class="count">{strings.imitationDropHere}</p>
        </div>
      )}
    </Workspace>
  );
}

/** A button that opens the browser's file dialog. */
function ChoosePicture({ strong }: { strong: boolean }) {
  const { imitation } = useApp();
  const input = useRef(null as HTMLInputElement | null);
  const choose = {
    label: strong ? strings.imitationChoose : strings.imitationOther,
    icon: 'open',
    run: () => input.current?.click(),
  };
  return (
    <>
      <ActionButton action={choose} class={strong ? 'button strong' : 'button'} text />
      <ChosenFiles input={input} accept={PICTURES} label={strings.imitationFile} onFiles={imitation.take} />
    </>
  );
}

/** The picture in the browser. If it cannot be shown, its file name appears. */
function Original() {
  const { picture } = useApp().imitation;
  const shown = picture.value;
  const address = useMemo(() => (shown ? URL.createObjectURL(shown.file) : ''), [shown]);
  useEffect(() => () => URL.revokeObjectURL(address), [address]);
  return (
    <figure class="imitation-figure">
      <div class="imitation-frame">
        {shown && <img src={address} alt={strings.imitationPictureOf({ name: shown.name })} />}
      </div>
      <figcaption class="count">{shown?.name}</figcaption>
    </figure>
  );
}

/** The user's photo in the selected style, or unchanged without one. */
function Result({ fact }: { fact: Shown }) {
  const { engine, imitation } = useApp();
  const style = imitation.proposals.value.find(({ id }) => id === imitation.shown.value);
  return (
    <figure class="imitation-figure">
      <div class="imitation-frame">
        <div
          class="imitation-result"
          role="img"
          aria-label={style ? strings.styleOn({ style: style.name, photo: fact.name }) : fact.name}
        >
          <Bitmap
            of={`${style?.id} ${fact.id}`}
            draw={(call) => engine.stylePhoto(fact.id, style ?? PLAIN, { ...sized(fact, LARGE), tier: 'work' }, call)}
          />
        </div>
      </div>
      <figcaption class="count">{style?.name ?? fact.name}</figcaption>
    </figure>
  );
}

/** Progress, or the reason why nothing was found. */
function Status({ fact }: { fact: Shown | null }) {
  const { imitation, actions } = useApp();
  const done = imitation.progress.value;
  return (
    <div class="imitation-status" aria-live="polite">
      {done !== null && (
        <>
          <span class="count">{strings.imitating}</span>
          <progress class="progress" aria-label={strings.imitating} value={done} max={1} />
          <ActionButton action={actions.imitation.stop} class="button small" text />
        </>
      )}
      {done === null && imitation.fault.value !== null && <p class="imitation-fault">{imitation.fault.value}</p>}
      {done === null && imitation.doubted.value && fact && (
        <ActionButton
          action={{ label: strings.imitationAnyway, run: () => imitation.insist(fact.id) }}
          class="button small"
          text
        />
      )}
      {done === null && imitation.proposals.value.length > 0 && (
        <span class="count">{strings.imitationFound({ n: imitation.proposals.value.length })}</span>
      )}
    </div>
  );
}

function Proposals({ fact }: { fact: Shown }) {
  const { imitation } = useApp();
  return (
    <ul class="imitation-proposals" aria-label={strings.imitationProposals}>
      {imitation.proposals.value.map((style) => (
        <Proposal key={style.id} style={style} fact={fact} />
      ))}
    </ul>
  );
}

function Proposal({ style, fact }: { style: Style; fact: Shown }) {
  const { engine, imitation } = useApp();
  return (
    <li>
      <button
        type="button"
        class="imitation-proposal"
        aria-label={style.name}
        title={style.name}
        aria-pressed={imitation.shown.value === style.id}
        onClick={() => imitation.choose(style.id)}
      >
        <Bitmap
          of={`${style.id} ${fact.id}`}
          draw={(call) => engine.stylePhoto(fact.id, style, { ...sized(fact, SMALL), tier: 'work' }, call)}
        />
      </button>
    </li>
  );
}

/** @returns the size of a photo whose long side covers `side` CSS pixels */
function sized({ meta: { width, height } }: Shown, side: number) {
  const factor = Math.min(screenPixels(side), MOST) / Math.max(width, height);
  return { width: Math.max(1, Math.round(width * factor)), height: Math.max(1, Math.round(height * factor)) };
}
