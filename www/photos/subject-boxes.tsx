/** Boxes of detected subjects: on the panels, clipped to their crops, and on a photo of the tray with its crops. */

import { useApp } from '../ui/context.ts';
import type { Bounds, Geometry, PageDocument } from '../engine/types.ts';

export function PanelSubjects({ page, geometry }: { page: PageDocument; geometry: Geometry }) {
  const { store } = useApp();
  const merged = new Set(page.merges.flat());
  const boxes = page.panels.flatMap(({ photo, crop }, panel) => {
    const bounds = geometry.panels[panel]?.bounds;
    // Merged panels show parts of one crop, without separate bounds.
    if (!bounds || !crop || merged.has(panel)) return [];
    const subjects = store.album.value.get(photo ?? '')?.meta?.subjects ?? [];
    return subjects.map((subject) => ({ ...within(subject, crop, bounds), label: subject.label, panel, bounds }));
  });
  const scale = ({ x, y, width, height }: Bounds) => ({
    x: x * 1000,
    y: y * 1000,
    width: width * 1000,
    height: height * 1000,
  });
  return (
    <svg class="subject-boxes" viewBox={`0 0 1000 ${geometry.height * 1000}`} aria-hidden="true">
      {geometry.panels.map(({ bounds }, i) => (
        <clipPath key={i} id={`subjects-${i}`}>
          <rect {...scale(bounds)} />
        </clipPath>
      ))}
      {boxes.map((box, i) => (
        <rect key={i} data-label={box.label} clip-path={`url(#subjects-${box.panel})`} {...scale(box)} />
      ))}
    </svg>
  );
}

export function PhotoSubjects({ id }: { id: string }) {
  const { store } = useApp();
  const meta = store.album.value.get(id)?.meta;
  if (!meta) return null;
  const { width, height } = meta;
  const side = Math.min(width, height);
  const crops = (store.page.value?.panels ?? []).flatMap(({ photo, crop }) => (photo === id && crop ? [crop] : []));
  const rect = (box: Bounds) => ({
    x: box.x * width,
    y: box.y * height,
    width: box.width * width,
    height: box.height * height,
  });
  return (
    <svg
      class="subject-boxes"
      viewBox={`${(width - side) / 2} ${(height - side) / 2} ${side} ${side}`}
      aria-hidden="true"
    >
      {crops.map((crop, i) => (
        <rect key={i} class="chosen-crop" {...rect(crop)} />
      ))}
      {meta.subjects.map((subject, i) => (
        <rect key={`s${i}`} data-label={subject.label} {...rect(subject)} />
      ))}
    </svg>
  );
}

/**
 * @param box in fractions of a photo
 * @param crop of it that is shown
 * @param bounds where it is shown
 */
function within(box: Bounds, crop: Bounds, bounds: Bounds): Bounds {
  const [across, down] = [bounds.width / crop.width, bounds.height / crop.height];
  return {
    x: bounds.x + (box.x - crop.x) * across,
    y: bounds.y + (box.y - crop.y) * down,
    width: box.width * across,
    height: box.height * down,
  };
}
