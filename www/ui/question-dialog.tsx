/** The dialog that asks before an action replaces work. */

import { strings } from '../strings/strings.ts';
import { useApp } from './context.ts';
import { Dialog } from './dialog.tsx';

export function QuestionDialog() {
  const { ui } = useApp();
  const question = ui.question.value;
  if (!question) return null;
  const close = () => {
    ui.question.value = null;
  };
  return (
    <Dialog title={question.yes} onClose={close} class="question">
      <p>{question.text}</p>
      <div class="question-ways">
        <button type="button" class="button" onClick={close}>
          {strings.cancel}
        </button>
        <button
          type="button"
          class="button strong"
          onClick={() => {
            close();
            question.run();
          }}
        >
          {question.yes}
        </button>
      </div>
    </Dialog>
  );
}
