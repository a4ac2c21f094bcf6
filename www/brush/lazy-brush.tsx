import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { useLoaded } from '../ui/loaded.ts';

/** The dialog in which the subject of a photo is corrected, which comes when it is first asked for. */
export function LazyBrush({ id }: { id: string }) {
  const { ui, messages } = useApp();
  const loaded = useLoaded(
    () => import('./brush-dialog.tsx'),
    () => {
      ui.dialog.value = null;
      messages.alert(strings.brush.missing);
    },
  );
  return loaded && <loaded.BrushDialog id={id} />;
}
