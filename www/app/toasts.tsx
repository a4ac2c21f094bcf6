/**
 * Messages, in live regions that are there from the start: a region that appears with its text is often not read.
 */

import { useLayoutEffect, useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { IconButton } from '../ui/button.tsx';
import { useApp } from '../ui/context.ts';
import { spot } from './drop.ts';
import { FailedFiles } from './failed-files.tsx';
import { Icon } from '../ui/icon.tsx';
import type { ComponentChildren } from 'preact';
import type { Action } from '../ui/action.ts';
import type { Message } from '../ui/messages.ts';

export function Toasts() {
  const { messages, download, keeping, actions, ui } = useApp();
  const opening = keeping.files.progress.value;
  const list = messages.list.value;
  const running = download.progress.value;
  const left = running?.left ?? null;
  const saving = keeping.files.saving.value;
  const percent = running ? strings.percent(running.done / Math.max(1, running.total)) : '';
  const exporting = running
    ? running.packing
      ? strings.packingPhotos({ percent })
      : running.filming
        ? (running.filming === 'pages' ? strings.motion : strings.animatic).making({ percent })
        : strings.exporting({ percent })
    : '';
  return (
    <>
      <div class="toasts">
        <div role="alert" class="toast-alerts">
          <Alerts class="toast-list toast-grave" list={list.filter(({ kind }) => kind === 'grave')} />
          <Alerts class="toast-list" list={list.filter(({ kind, near }) => kind === 'alert' && !near)} />
          <Alerts
            class="toast-list toast-near"
            list={list.filter(({ near }) => near)}
            at={ui.work.value === null ? null : spot.value}
            near
          />
        </div>
        {running && (
          <Work label={exporting} done={running.done} total={running.total} cancel={actions.download.cancel}>
            {left !== null && <span class="toast-left">{timeLeft(left)}</span>}
          </Work>
        )}
        {saving && (
          <Work
            label={strings.savingProject({ done: Math.floor(saving.done), total: saving.total })}
            name={strings.saveProject}
            done={saving.done}
            total={saving.total}
            cancel={actions.projects.cancelSaving}
          />
        )}
        {opening && (
          <Work
            label={strings.openingProject({ name: opening.name })}
            done={opening.done}
            total={opening.total}
            cancel={actions.projects.cancelOpening}
          />
        )}
        <div role="status" class="toast-list">
          {list
            .filter(({ kind }) => kind === 'offer' || kind === 'note')
            .map(({ id, kind, text, way, more }) => (
              <div class="toast" key={id}>
                <Said text={text} way={way} more={more} close={() => messages.close(id)} />
                {kind === 'offer' && (
                  <IconButton icon="close" label={strings.dismiss} onClick={() => messages.close(id)} />
                )}
              </div>
            ))}
        </div>
      </div>
      {messages.listed.value && <FailedFiles />}
    </>
  );
}

/** Running work. @param props `name`: the accessible name of its progress, if it differs from the label */
function Work({
  label,
  name = label,
  done,
  total,
  cancel,
  children,
}: {
  label: string;
  name?: string;
  done: number;
  total: number;
  cancel: Action;
  children?: ComponentChildren;
}) {
  return (
    <div class="toast" aria-busy="true">
      <div class="toast-work">
        <span>
          {label}
          {children}
        </span>
        <progress class="progress" aria-label={name} value={done} max={Math.max(1, total)} />
      </div>
      <ActionButton action={cancel} class="button" text />
    </div>
  );
}

/** @param seconds a multiple of five */
function timeLeft(seconds: number): string {
  if (seconds < 60) return strings.timeLeft.seconds({ n: seconds });
  return strings.timeLeft.minutes({ n: Math.ceil(seconds / 60) });
}

/**
 * @param props `at`: the point below which they are, in CSS pixels; `near`: they are below the heading of the photos, or
 *   below the buttons of the start screen, which leave room for them
 */
function Alerts({
  list,
  class: name,
  at = null,
  near = false,
}: {
  list: Message[];
  class: string;
  at?: { x: number; y: number } | null;
  near?: boolean;
}) {
  const { messages } = useApp();
  const ref = useRef(null as HTMLDivElement | null);
  useLayoutEffect(() => {
    if (!near || !ref.current) return undefined;
    const observer = new ResizeObserver(([{ target }]) =>
      document.documentElement.style.setProperty('--files', `${(target as HTMLElement).offsetHeight}px`),
    );
    observer.observe(ref.current);
    return () => observer.disconnect();
  }, []);
  return (
    <div
      ref={ref}
      class={name}
      data-placed={at !== null}
      style={at ? { '--x': `${at.x}px`, '--y': `${at.y}px` } : undefined}
    >
      {list.map(({ id, text, way, more }) => (
        <div class="toast bad" key={id}>
          <Icon name="alert" />
          <Said text={text} way={way} more={more} close={() => messages.close(id)} short={SHORT_ALERT} />
          <IconButton icon="close" label={strings.dismiss} onClick={() => messages.close(id)} />
        </div>
      ))}
    </div>
  );
}

/**
 * Maximum characters of a text with a button next to it. Longer texts would become a column with one word per line. An
 * icon and `Dismiss` need space too.
 */
const SHORT = 60;
const SHORT_ALERT = 20;

/** A long text and two actions are on separate lines. */
function Said({
  text,
  way,
  more,
  close,
  short = SHORT,
}: Pick<Message, 'text' | 'way' | 'more'> & { close: () => void; short?: number }) {
  if (!more && (!way || text.length <= short))
    return (
      <>
        <span class="toast-text">{text}</span>
        <Way of={way} close={close} />
      </>
    );
  return (
    <div class="toast-body">
      <span class="toast-text">{text}</span>
      <span class="toast-ways">
        <Way of={way} close={close} />
        <Way of={more} close={close} />
      </span>
    </div>
  );
}

function Way({ of, close }: { of: import('../ui/messages.ts').Way | undefined; close: () => void }) {
  if (!of) return null;
  const action = {
    label: of.label,
    run() {
      if (!of.stays) close();
      of.run();
    },
  };
  return <ActionButton action={action} class="button" text />;
}
