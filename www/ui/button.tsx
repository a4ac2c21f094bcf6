import { Icon } from './icon.tsx';

/**
 * A button that is only an icon to the eye and has its name for everyone: read aloud, and shown on hover.
 * @param props `help`: tooltip, instead of the name
 */
export function IconButton({
  icon,
  label,
  onClick,
  disabled = false,
  pressed,
  expanded,
  class: extra = '',
  help = label,
}: {
  icon: string;
  label: string;
  onClick: () => void;
  disabled?: boolean;
  pressed?: boolean;
  expanded?: boolean;
  class?: string;
  help?: string;
}) {
  return (
    <button
      type="button"
      class={`icon-button ${extra}`}
      aria-label={label}
      aria-pressed={pressed}
      aria-expanded={expanded}
      title={help}
      disabled={disabled}
      onClick={onClick}
    >
      <Icon name={icon} />
    </button>
  );
}
