import { isEnabled, now } from './action.ts';
import { useApp } from './context.ts';
import { Icon } from './icon.tsx';
import { ariaShortcut, keyNames } from './shortcut.ts';
import type { ComponentChildren, Ref } from 'preact';
import type { Action } from './action.ts';

/**
 * The button of an action, with its accessible name and a tooltip.
 * @param props `text`: shows the name next to the icon. `opens`: the switched part appears next to it, like a drawer.
 *   `explains`: shows the reason if it cannot be used. `tells`: a press says the reason, for touch screens without
 *   tooltips. `named`: touch screens show the short name below the icon. `children`: replaces icon and text. `busy`: its work is running. `button`: receives the element
 */
export function ActionButton({
  action,
  class: look = 'icon-button',
  text = false,
  opens = false,
  explains = false,
  tells = false,
  named = false,
  children,
  busy,
  button,
}: {
  action: Action;
  class?: string;
  text?: boolean;
  opens?: boolean;
  explains?: boolean;
  tells?: boolean;
  named?: boolean;
  children?: ComponentChildren;
  busy?: boolean;
  button?: Ref<HTMLButtonElement>;
}) {
  const { messages } = useApp();
  const { short, run } = action;
  const on = now(action.on);
  const label = now(action.label);
  const icon = now(action.icon);
  const shown = text ? (short ?? label) : '';
  const shortcut = action.keys?.[0];
  const help = now(action.help) ?? label;
  const why = now(action.why);
  const told = shortcut ? `${help} (${keyNames(shortcut).join('+')})` : help;
  // The end of a sentence makes no way for a reason.
  const title = why ? `${told.replace(/[.。]$/u, '')}: ${why}` : told;
  const isTold = tells && !!why;
  return (
    <button
      type="button"
      ref={button}
      class={look}
      aria-busy={busy}
      aria-label={shown === label && !(explains && why) ? undefined : label}
      aria-pressed={opens ? undefined : on}
      aria-expanded={opens ? on : undefined}
      aria-keyshortcuts={shortcut && ariaShortcut(shortcut)}
      title={title === shown ? undefined : title}
      disabled={!isEnabled(action) && !isTold}
      aria-disabled={isTold || undefined}
      onClick={isTold ? () => messages.note(why) : run}
    >
      {children ?? (
        <>
          {icon && <Icon name={icon} />}
          {shown && <span>{shown}</span>}
          {named && (
            <span class="icon-text" aria-hidden="true">
              {short}
            </span>
          )}
          {explains && why && <small>{why}</small>}
        </>
      )}
    </button>
  );
}
