import { strings } from '../strings/strings.ts';
import { useApp } from '../ui/context.ts';
import { useLoaded } from '../ui/loaded.ts';

/** The dialog for correcting the subject of a photo. It is loaded on first use. */
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
