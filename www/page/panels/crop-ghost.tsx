/**
 * The whole photo of a panel while it is cropped, in its place around the panel. Its parts outside of the panel are
 * dimmed, and fade out before they hide the other panels. The panel itself stays free, as it shows the result.
 */

import { PLAIN } from '../../photos/cover.ts';
import { Bitmap, screenPixels } from '../../ui/bitmap.tsx';
import { useApp } from '../../ui/context.ts';
import type { Bounds, Geometry, PageDocument } from '../../engine/types.ts';
import type { PanelShape } from './panel-shape.ts';

/** Longer side of the drawn photo in CSS pixels. A dimmed photo needs no details. */
const SIDE = 480;
/** Number of corners of the polygon that replaces a circle. */
const ROUND = 48;

export function CropGhost({ page, geometry }: { page: PageDocument; geometry: Geometry }) {
  const { framing, store, engine } = useApp();
  const panel = framing.framed.value;
  if (panel === null) return null;
  const group = framing.groupAt(page, panel);
  const { photo, crop } = page.panels[group[0]] ?? {};
  const bounds = framing.boundsOf(panel);
  const meta = store.album.value.get(photo ?? '')?.meta;
  if (!photo || !crop || !bounds || !meta || !engine.hasPhoto(photo)) return null;
  const whole = wholePhoto(bounds, crop);
  const scale = SIDE / Math.max(meta.width, meta.height);
  const [width, height] = [screenPixels(meta.width * scale), screenPixels(meta.height * scale)];
  const all = { x: 0, y: 0, width: 1, height: 1 };
  return (
    <div
      class="crop-ghost"
      aria-hidden="true"
      style={{
        left: `${whole.x * 100}%`,
        top: `${(whole.y / geometry.height) * 100}%`,
        width: `${whole.width * 100}%`,
        height: `${(whole.height / geometry.height) * 100}%`,
        '--left': part(bounds.x, whole.x, whole.width),
        '--right': part(bounds.x + bounds.width, whole.x, whole.width),
        '--top': part(bounds.y, whole.y, whole.height),
        '--bottom': part(bounds.y + bounds.height, whole.y, whole.height),
        clipPath: withHoles(group.flatMap((i) => geometry.panels[i] ?? []).map((one) => cornersIn(one, whole))),
      }}
    >
      <Bitmap of={photo} draw={(call) => engine.stylePhoto(photo, PLAIN, { width, height, crop: all }, call)} />
    </div>
  );
}

/**
 * @param bounds of the image on the page
 * @param crop the part of the photo that the image shows
 * @returns the bounds of the whole photo, in the units of `bounds`
 */
export function wholePhoto(bounds: Bounds, crop: Bounds): Bounds {
  const [width, height] = [bounds.width / crop.width, bounds.height / crop.height];
  return { x: bounds.x - crop.x * width, y: bounds.y - crop.y * height, width, height };
}

/** A position as a percentage of the photo. */
function part(at: number, from: number, length: number): string {
  return `${(((at - from) / length) * 100).toFixed(3)}%`;
}

/** The corners of a panel as percentages of the photo. */
function cornersIn({ polygon = [], circle }: PanelShape, whole: Bounds): string[] {
  const corners = circle ? around(circle) : polygon;
  return corners.map(([x, y]) => `${part(x, whole.x, whole.width)} ${part(y, whole.y, whole.height)}`);
}

function around({ x, y, radius }: { x: number; y: number; radius: number }): [number, number][] {
  return Array.from({ length: ROUND }, (_, i) => {
    const angle = (2 * Math.PI * i) / ROUND;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  });
}

/** A CSS clip path: everything except the holes. The path returns to the first corner between two outlines. */
export function withHoles(holes: readonly (readonly string[])[]): string {
  const outlines = holes.flatMap((hole) => [...hole, ...hole.slice(0, 1), '0 0']);
  return `polygon(evenodd, ${['0 0', '100% 0', '100% 100%', '0 100%', '0 0', ...outlines].join(', ')})`;
}
