import { strings } from '../strings/strings.ts';
import { useApp } from './context.ts';
import { Icon } from '../ui/icon.tsx';
import { ShuffleButton } from '../page/shuffle-bar.tsx';
import type { Sheet } from './ui.ts';

/** The bar under the thumb: Shuffle in the middle, the sheets beside it. */
export function BottomBar() {
  const { store, ui } = useApp();
  return (
    <nav class="bottom-bar" aria-label={strings.name}>
      <Tab sheet="photos" icon="photos" label={strings.photos} />
      <Tab sheet="styles" icon="style" label={strings.styles} />
      <ShuffleButton />
      <Tab sheet="layouts" icon="layout" label={strings.layouts} />
      <Tab sheet="words" icon="balloon" label={strings.words} />
      <button
        type="button"
        class="tab"
        disabled={store.page.value === null}
        onClick={() => {
          ui.dialog.value = 'export';
        }}
      >
        <Icon name="export" />
        {strings.export}
      </button>
    </nav>
  );
}

function Tab({ sheet, icon, label }: { sheet: Sheet; icon: string; label: string }) {
  const { ui } = useApp();
  const open = ui.sheet.value === sheet;
  return (
    <button
      type="button"
      class="tab"
      aria-expanded={open}
      onClick={() => {
        ui.sheet.value = open ? null : sheet;
      }}
    >
      <Icon name={icon} />
      {label}
    </button>
  );
}
