import { Icon } from './icon.tsx';

/**
 * A button that is only an icon to the eye and has its name for everyone: read aloud, and shown on hover.
 * @param props `help`: tooltip, instead of the name; `short`: text below the icon on touch screens, which have no tooltips
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
  short,
}: {
  icon: string;
  label: string;
  onClick: () => void;
  disabled?: boolean;
  pressed?: boolean;
  expanded?: boolean;
  class?: string;
  help?: string;
  short?: string;
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
      {short !== undefined && (
        <span class="icon-text" aria-hidden="true">
          {short}
        </span>
      )}
    </button>
  );
}
