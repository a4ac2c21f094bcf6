import { textAt } from '../strings/compose.ts';
import { strings } from '../strings/strings.ts';
import { ActionButton } from '../ui/action-button.tsx';
import { useApp } from '../ui/context.ts';
import { Icon } from '../ui/icon.tsx';

/** Message about a project that cannot be opened, with possible actions. */
export function Broken() {
  const { keeping, ui, actions } = useApp();
  const { goBack, openAnother, saveBroken } = actions.projects;
  const project = keeping.broken.value;
  if (!project) return null;
  const { name, why, detail, back } = project;
  const listed = ui.work.value === 'projects';
  const said = strings.projectBroken({
    name: name || strings.untitled,
    why: textAt(strings.brokenReasons, why) ?? strings.brokenOtherwise,
  });
  return (
    <div class="broken" role="group" aria-label={said}>
      <p class="broken-what" role="alert">
        <Icon name="alert" />
        <span>{said}</span>
      </p>
      <p class="broken-more">
        {strings.brokenKept} {!back && strings.noGoodState}
      </p>
      <p class="broken-ways">
        {back && <ActionButton action={goBack} class="button strong" text />}
        {!listed && <ActionButton action={openAnother} class="button" text />}
        <ActionButton action={saveBroken} class="button" text />
      </p>
      {detail !== '' && (
        <p class="broken-detail">
          <code>{detail.slice(0, MOST)}</code>
        </p>
      )}
    </div>
  );
}

/** Maximum length of the error message in characters. */
const MOST = 200;
