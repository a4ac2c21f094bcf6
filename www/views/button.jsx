// @ts-check
import { Icon } from './icon.jsx';

/**
 * A button that is only an icon to the eye and has its name for everyone: read aloud, and shown on hover.
 * @param {{
 *   icon: string, label: string, onClick: () => void, disabled?: boolean, pressed?: boolean, shortcut?: string, class?: string,
 * }} props
 */
export function IconButton({ icon, label, onClick, disabled = false, pressed, shortcut, class: extra = '' }) {
  return (
    <button
      type="button"
      class={`icon-button ${extra}`}
      aria-label={label}
      aria-pressed={pressed}
      aria-keyshortcuts={shortcut}
      title={shortcut ? `${label} (${shortcut})` : label}
      disabled={disabled}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
