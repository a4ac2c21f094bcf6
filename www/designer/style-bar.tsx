/** What can be done with the designed style as a whole. */

import { useRef } from 'preact/hooks';
import { strings } from '../strings/strings.ts';
import { IconButton } from '../ui/button.tsx';
import { ChosenFiles, JSON_FILES } from '../photos/chosen-files.tsx';
import { useApp } from '../app/context.ts';
import { Icon } from '../ui/icon.tsx';
import type { Style } from '../engine/documents.ts';

/** Entries of `Start from` that are no style. */
const [EMPTY, PAGE] = ['#empty', '#page'];

export function StyleBar() {
  const { store, designer, ownStyles } = useApp();
  const file = useRef(null as HTMLInputElement | null);
  const draft = designer.draft.value;
  if (!draft) return null;
  const own = ownStyles.mine.value.some(({ id }) => id === draft.id);
  const empty = draft.background.length + draft.foreground.length === 0;

  /** @param deed on the style as the core has checked it */
  const withStyle = (deed: (style: Style) => void) => () => {
    const style = designer.checked();
    if (style) deed(style);
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
        <button type="button" class="button" disabled={empty} onClick={withStyle(ownStyles.save)}>
          <Icon name="save" />
          {strings.saveStyle}
        </button>
        <IconButton icon="export" label={strings.exportStyle} onClick={withStyle(ownStyles.exportFile)} />
        <IconButton icon="open" label={strings.importStyle} onClick={() => file.current?.click()} />
        <IconButton
          icon="link"
          label={strings.copyLink}
          onClick={withStyle(
            (style) =>
              void ownStyles.copyLink(style, {
                address: globalThis.location.href,
                write: async (text) => navigator.clipboard.writeText(text),
              }),
          )}
        />
        <IconButton
          icon="duplicate"
          label={strings.duplicateStyle}
          onClick={withStyle((style) => designer.begin(ownStyles.duplicate(style)))}
        />
        <IconButton icon="bin" label={strings.deleteStyle} disabled={!own} onClick={() => ownStyles.remove(draft.id)} />
        <button type="button" class="button strong" disabled={store.page.value === null} onClick={designer.use}>
          <Icon name="check" />
          {strings.useStyle}
        </button>
      </div>
      <ChosenFiles input={file} accept={JSON_FILES} label={strings.styleFile} onFiles={ownStyles.open} />
    </div>
  );
}

function StartFrom() {
  const { store, designer, ownStyles } = useApp();
  const mine = ownStyles.mine.value;
  const favourites = ownStyles.favourites.value.filter(({ id }) => mine.every((style) => style.id !== id));
  const designed = store.planner.value?.styles() ?? [];

  function start(select: HTMLSelectElement) {
    const { value } = select;
    select.value = '';
    if (value === PAGE) designer.beginWithPage();
    else designer.begin([...mine, ...favourites, ...designed].find(({ id }) => id === value) ?? null);
  }

  return (
    <select class="select" aria-label={strings.startFrom} value="" onChange={(event) => start(event.currentTarget)}>
      <option value="" disabled>
        {strings.startFromWhat}
      </option>
      <option value={EMPTY}>{strings.newStyle}</option>
      {store.page.value && <option value={PAGE}>{strings.pageStyle}</option>}
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
