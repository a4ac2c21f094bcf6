/**
 * Models of painters of the user: checked by the core, stored in this browser, and named by styles. A style without its
 * model is drawn with the built-in painters.
 */

import { computed, signal } from '@preact/signals';
import { MOST } from '../document/limits.ts';
import { crcOf } from '../engine/crc.ts';
import { failure } from '../engine/protocol.ts';
import { strings } from '../strings/strings.ts';
import { importing } from '../ui/importing.ts';
import { partsOf, referenceOf, referencesIn } from './references.ts';
import type { Store } from '../document/store.ts';
import type { OwnFiles } from '../engine/painters.ts';
import type { Draft, DraftEdit, Layer } from '../engine/types.ts';
import type { Messages } from '../ui/messages.ts';
import type { Ui } from '../ui/ui.ts';
import type { ModelShelf } from './model-shelf.ts';
import type { ReadonlySignal, Signal } from '@preact/signals';

/** `painters` is the number of them. */
export type OwnModel = { name: string; painters: number; file: Blob };
export type OwnPainters = ReturnType<typeof createOwnPainters>;

const LAYERS: readonly Layer[] = ['background', 'foreground'];

export function createOwnPainters({
  store,
  messages,
  designer,
  ui,
  shelf,
}: {
  store: Pick<Store, 'planner' | 'page'>;
  messages: Pick<Messages, 'note' | 'fileFailed'>;
  designer: { draft: ReadonlySignal<Draft | null>; change: (edit: DraftEdit) => void };
  ui: Pick<Ui, 'work'>;
  shelf: ModelShelf;
}) {
  /** By id, in the order in which they were added. */
  const models: Signal<ReadonlyMap<string, OwnModel>> = signal(new Map());
  const loaded = signal(false);
  const loading = recall();

  /** References of the page's style without a model here. */
  const missing = computed(() =>
    loaded.value ? referencesIn(store.page.value?.style).filter((it) => !models.value.has(partsOf(it).id)) : [],
  );

  return { models, missing, add, open, remove, files };

  async function recall() {
    // Without storage, there are no models yet.
    const kept = await shelf.all().catch(() => []);
    const found = kept.map(
      ({ id, name, painters, bytes }) => [id, { name, painters, file: new Blob([bytes]) }] as const,
    );
    models.value = new Map([...found, ...models.peek()]);
    loaded.value = true;
  }

  /** Files of some models, for a worker. */
  async function files(ids: readonly string[]): Promise<OwnFiles> {
    await loading;
    const there = ids.flatMap((id) => {
      const model = models.peek().get(id);
      return model ? [[id, model.file] as const] : [];
    });
    return Object.fromEntries(there);
  }

  /**
   * Checks and stores a model.
   * @returns its reference. Rejects with the reason, and changes nothing
   */
  async function add(file: File): Promise<string> {
    const planner = store.planner.peek();
    if (!planner) throw failure('core-missing', 'The program is not loaded yet.');
    if (file.size > MOST.painters) {
      throw failure(
        'large-painters',
        `this model of painters is too large: it has ${file.size} bytes, the limit is ${MOST.painters}`,
      );
    }
    const bytes = await file.arrayBuffer();
    const painters = planner.paintersIn(new Uint8Array(bytes));
    const hex = (number: number) => number.toString(16).padStart(8, '0');
    const id = `${hex(await crcOf(new Blob([bytes])))}${hex(bytes.byteLength)}`;
    const reference = referenceOf(id, file.name);
    const { name } = partsOf(reference);
    await loading;
    models.value = new Map(models.peek()).set(id, { name, painters, file: new Blob([bytes]) });
    await shelf.put({ id, name, painters, bytes }).catch(() => messages.note(strings.modelNotKept({ name })));
    return reference;
  }

  /** Adds dropped files. The last one is used by the first block Painter of the designer, if it is open. */
  async function open(dropped: readonly File[]) {
    for (const file of dropped) {
      const reference = await importing(messages, file.name, () => add(file));
      if (reference === undefined) continue;
      const edit = ui.work.peek() === 'designer' ? firstPainter(reference) : null;
      if (edit) designer.change(edit);
      else messages.note(strings.modelReady({ name: partsOf(reference).name }));
    }
  }

  function firstPainter(value: string): DraftEdit | null {
    const draft = designer.draft.peek();
    for (const layer of LAYERS) {
      const at = draft?.[layer].findIndex(({ block, bypass }) => block === 'painter' && !bypass) ?? -1;
      if (at >= 0) return { type: 'set', layer, at, param: 'model', value };
    }
    return null;
  }

  /** Removes a model from this browser. The message brings it back. */
  async function remove(id: string) {
    const gone = models.peek().get(id);
    if (!gone) return;
    models.value = new Map([...models.peek()].filter(([other]) => other !== id));
    await shelf.remove(id).catch(() => {});
    messages.note(strings.modelRemoved({ name: gone.name }), {
      label: strings.undo,
      run: () => void importing(messages, gone.name, () => add(new File([gone.file], gone.name))),
    });
  }
}
