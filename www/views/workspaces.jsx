// @ts-check
import { strings } from '../strings.js';
import { useApp } from './context.js';
import { Icon } from './icon.jsx';

/** The ways to what lies over the board: in the bar above, on a small screen among the styles. */
export function Workspaces() {
  const { ui, designer } = useApp();
  const button = (/** @type {'designer' | 'explorer'} */ work, /** @type {() => void} */ open) => {
    const on = ui.work.value === work;
    return (
      <button type="button" key={work} class="button" aria-pressed={on} onClick={on ? designer.close : open}>
        <Icon name={work} />{strings[work]}
      </button>
    );
  };
  return <>{button('designer', () => designer.open())}{button('explorer', () => { ui.work.value = 'explorer'; })}</>;
}
