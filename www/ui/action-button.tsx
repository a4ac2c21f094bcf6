import { isEnabled, now } from './action.ts';
import { useApp } from './context.ts';
import { Icon } from './icon.tsx';
import { ariaShortcut, keyNames } from './shortcut.ts';
import type { ComponentChildren } from 'preact';
import type { Action } from './action.ts';

/**
 * The button of an action, with its accessible name and a tooltip.
 * @param props `text`: shows the name next to the icon. `opens`: the switched part appears next to it, like a drawer.
 *   `explains`: shows the reason if it cannot be used. `tells`: a press says the reason, for touch screens without
 *   tooltips. `children`: replaces icon and text
 */
export function ActionButton({
  action,
  class: look = 'icon-button',
  text = false,
  opens = false,
  explains = false,
  tells = false,
  children,
}: {
  action: Action;
  class?: string;
  text?: boolean;
  opens?: boolean;
  explains?: boolean;
  tells?: boolean;
  children?: ComponentChildren;
}) {
  const { messages } = useApp();
  const { short, on, run } = action;
  const label = now(action.label);
  const icon = now(action.icon);
  const shown = text ? (short ?? label) : '';
  const shortcut = action.keys?.[0];
  const help = now(action.help) ?? label;
  const why = action.why?.value;
  const told = shortcut ? `${help} (${keyNames(shortcut).join('+')})` : help;
  // The end of a sentence makes no way for a reason.
  const title = why ? `${told.replace(/[.。]$/u, '')}: ${why}` : told;
  const isTold = tells && !!why;
  return (
    <button
      type="button"
      class={look}
      aria-label={shown === label && !(explains && why) ? undefined : label}
      aria-pressed={opens ? undefined : on?.value}
      aria-expanded={opens ? on?.value : undefined}
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
          {explains && why && <small>{why}</small>}
        </>
      )}
    </button>
  );
}
