/** Small marks on panels: a lock, and the point that matters in a photo. */

import { useApp } from '../../ui/context.ts';
import { Icon } from '../../ui/icon.tsx';
import type { Bounds, Geometry, PageDocument } from '../../engine/types.ts';

export function PanelMarks({ page, geometry }: { page: PageDocument; geometry: Geometry }) {
  const { framing, store, selection } = useApp();
  const mode = framing.mode.value;
  const [chosen] = selection.panels.value;
  const point = focusOf(mode?.kind === 'focus' ? mode.panel : chosen);
  return (
    <div class="panel-marks">
      {page.panels.map(
        (use, i) =>
          use.locked &&
          geometry.panels[i] && (
            <span key={i} class="panel-lock" aria-hidden="true" style={corner(geometry.panels[i])}>
              <Icon name="lock" />
            </span>
          ),
      )}
      {point && <span class="panel-focus" aria-hidden="true" style={at(point.bounds, point.u, point.v)} />}
    </div>
  );

  function focusOf(panel: number | undefined): { bounds: Bounds; u: number; v: number } | null {
    if (panel === undefined) return null;
    const bounds = framing.boundsOf(panel);
    if (!bounds) return null;
    if (mode?.kind === 'focus') return { bounds, u: mode.at?.[0] ?? 0.5, v: mode.at?.[1] ?? 0.5 };
    const crop = framing.cropOf(panel);
    const focus = store.photos.value.find(({ id }) => id === page.panels[panel]?.photo)?.focus;
    if (!crop || !focus) return null;
    const [u, v] = [(focus.x - crop.x) / crop.width, (focus.y - crop.y) / crop.height];
    return u >= 0 && u <= 1 && v >= 0 && v <= 1 ? { bounds, u, v } : null;
  }

  /** Inside the first corner of a panel, however slanted it is. */
  function corner({ polygon = [], bounds }: Geometry['panels'][number]) {
    const middle = [bounds.x + bounds.width / 2, bounds.y + bounds.height / 2];
    const [x, y] = polygon[0] ?? [middle[0], bounds.y];
    const inward = polygon.length > 0 ? 0.2 : 0.3;
    return at({ x: x + (middle[0] - x) * inward, y: y + (middle[1] - y) * inward, width: 0, height: 0 }, 0, 0);
  }

  function at({ x, y, width, height }: Bounds, u: number, v: number) {
    return { left: `${(x + u * width) * 100}%`, top: `${((y + v * height) / geometry.height) * 100}%` };
  }
}
