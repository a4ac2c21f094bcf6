/** The dialog that asks before an action replaces work. */

import { strings } from '../strings/strings.ts';
import { ActionButton } from './action-button.tsx';
import { useApp } from './context.ts';
import { Dialog } from './dialog.tsx';

export function QuestionDialog() {
  const { ui } = useApp();
  const question = ui.question.value;
  if (!question) return null;
  const close = () => {
    ui.question.value = null;
  };
  const confirm = {
    label: question.yes,
    run() {
      close();
      question.run();
    },
  };
  return (
    <Dialog title={question.yes} onClose={close} class="question">
      <p>{question.text}</p>
      <div class="question-ways">
        <ActionButton action={{ label: strings.cancel, run: close }} class="button" text />
        <ActionButton action={confirm} class="button strong" text />
      </div>
    </Dialog>
  );
}
