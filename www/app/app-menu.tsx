import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { Menu } from '../ui/menu.tsx';
import { LanguageChoice } from '../help/language-choice.tsx';
import { ThemeChoice } from '../help/theme-choice.tsx';
import { strings } from '../strings/strings.ts';

/** Help, theme and language; on a small screen the views and the page settings, too. */
export function AppMenu() {
  const { store, ui, actions } = useApp();
  const { settings, comic, boards, designer, explorer, help } = actions.window;
  const small = !ui.wide.value && store.page.value !== null;
  return (
    <Menu icon="menu" label={strings.menu}>
      {[...(small ? [settings, comic, boards, designer, explorer] : []), help].map((action, i) => (
        <ActionButton key={i} action={action} class="menu-item" text />
      ))}
      <ThemeChoice />
      <LanguageChoice />
    </Menu>
  );
}
