/** Controls for the whole designed style. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { ChosenFiles, JSON_FILES } from '../photos/chosen-files.tsx';
import { useApp } from '../ui/context.ts';
import { ActionButton } from '../ui/action-button.tsx';

/** Entries of `Start from` that are not styles. */
const [EMPTY, PAGE, PICTURE] = ['#empty', '#page', '#picture'];

export function StyleBar() {
  const { designer, ownStyles, actions } = useApp();
  const file = useRef(null as HTMLInputElement | null);
  const draft = designer.draft.value;
  if (!draft) return null;
  const { exportStyle, copyLink, duplicate, remove } = actions.designer;
  const importStyle = {
    label: strings.importStyle,
    icon: 'open',
    run: () => file.current?.click(),
  };
  return (
    <div class="style-bar">
      <StartFrom />
      <input
        class="text style-name"
        type="text"
        aria-label={strings.styleName}
        maxLength={80}
        value={draft.name}
        onChange={(event) => designer.change({ type: 'name', name: event.currentTarget.value })}
      />
      <div class="style-tools">
        <ActionButton action={actions.designer.save} class="button" text />
        {[exportStyle, importStyle, copyLink, duplicate, remove].map((action) => (
          <ActionButton key={action.label} action={action} class="tool" text />
        ))}
        <ActionButton action={actions.designer.use} class="button strong" text />
      </div>
      <ChosenFiles input={file} accept={JSON_FILES} label={strings.styleFile} onFiles={ownStyles.open} />
    </div>
  );
}

function StartFrom() {
  const { store, designer, ownStyles, actions } = useApp();
  const mine = ownStyles.mine.value;
  const favourites = ownStyles.favourites.value.filter(({ id }) => mine.every((style) => style.id !== id));
  const designed = store.planner.value?.styles() ?? [];

  function start(select: HTMLSelectElement) {
    const { value } = select;
    select.value = '';
    if (value === PAGE) designer.beginWithPage();
    else if (value === PICTURE) actions.imitation.open.run();
    else designer.begin([...mine, ...favourites, ...designed].find(({ id }) => id === value) ?? null);
  }

  return (
    <select class="select" aria-label={strings.startFrom} value="" onChange={(event) => start(event.currentTarget)}>
      <option value="" disabled>
        {strings.startFromWhat}
      </option>
      <option value={EMPTY}>{strings.newStyle}</option>
      {store.page.value && <option value={PAGE}>{strings.pageStyle}</option>}
      <option value={PICTURE}>{strings.styleFromPicture}</option>
      {[
        { name: strings.myStyles, styles: mine },
        { name: strings.favourites, styles: favourites },
        { name: strings.designedStyles, styles: designed },
      ]
        .filter(({ styles }) => styles.length > 0)
        .map(({ name, styles }) => (
          <optgroup key={name} label={name}>
            {styles.map((style) => (
              <option key={style.id} value={style.id}>
                {strings.styleTitle(style)}
              </option>
            ))}
          </optgroup>
        ))}
    </select>
  );
}
