import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';
import { THEMES } from '../ui/theme.ts';

const ICONS = { light: 'sun', dark: 'moon', system: 'system' };

export function ThemeChoice() {
  const { ui } = useApp();
  return (
    <fieldset class="themes">
      <legend>{strings.theme}</legend>
      {THEMES.map((theme) => (
        <label key={theme}>
          <input type="radio" name="theme" checked={ui.theme.value === theme} onChange={() => ui.useTheme(theme)} />
          <Icon name={ICONS[theme]} />
          <span>{strings.themes[theme]}</span>
        </label>
      ))}
    </fieldset>
  );
}
