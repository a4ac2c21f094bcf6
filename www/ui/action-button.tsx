import { isEnabled, now } from './action.ts';
import { Icon } from './icon.tsx';
import { ariaShortcut, keyNames } from './shortcut.ts';
import type { ComponentChildren } from 'preact';
import type { Action } from './action.ts';

/**
 * The button of an action, with its accessible name and a tooltip.
 * @param props `text`: shows the name next to the icon. `opens`: the switched part appears next to it, like a drawer.
 *   `explains`: shows the reason if it cannot be used. `children`: replaces icon and text
 */
export function ActionButton({
  action,
  class: look = 'icon-button',
  text = false,
  opens = false,
  explains = false,
  children,
}: {
  action: Action;
  class?: string;
  text?: boolean;
  opens?: boolean;
  explains?: boolean;
  children?: ComponentChildren;
}) {
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
  return (
    <button
      type="button"
      class={look}
      aria-label={shown === label && !(explains && why) ? undefined : label}
      aria-pressed={opens ? undefined : on?.value}
      aria-expanded={opens ? on?.value : undefined}
      aria-keyshortcuts={shortcut && ariaShortcut(shortcut)}
      title={title === shown ? undefined : title}
      disabled={!isEnabled(action)}
      onClick={run}
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
