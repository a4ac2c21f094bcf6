import { strings } from '../strings/strings.ts';
import { useApp } from './context.ts';
import { Icon } from '../ui/icon.tsx';

/** The ways to what lies over the board: in the bar above, on a small screen among the styles. */
export function Workspaces() {
  const { ui, designer } = useApp();
  const button = (work: 'designer' | 'explorer', open: () => void) => {
    const on = ui.work.value === work;
    return (
      <button type="button" key={work} class="button" aria-pressed={on} onClick={on ? designer.close : open}>
        <Icon name={work} />
        {strings[work]}
      </button>
    );
  };
  return (
    <>
      {button('designer', () => designer.open())}
      {button('explorer', () => {
        ui.work.value = 'explorer';
      })}
    </>
  );
}
