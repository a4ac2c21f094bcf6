/**
 * Draws a page on a canvas from the pictures of its panels.
 */

import { panelOf } from '../engine/figures.ts';
import { shown } from './patches.ts';
import type { Thumbnail } from '../engine/photo-header.ts';
import type { Geometry } from '../engine/types.ts';
import type { Sheet, Slot } from './painter.ts';
import type { Patch } from './patches.ts';

/** @returns of the canvas */
export function sheetSize({ document, width }: Sheet): { width: number; height: number } {
  return { width, height: Math.max(1, Math.round((width * document.page.height) / document.page.width)) };
}

/** @param thumbnailOf a photo without a picture yet */
export function drawPage(
  context: CanvasRenderingContext2D,
  sheet: Sheet,
  thumbnailOf: (photo: string) => Thumbnail | undefined = () => undefined,
) {
  const { width, height } = sheetSize(sheet);
  context.imageSmoothingQuality = 'high';
  context.fillStyle = sheet.document.page.paper;
  context.fillRect(0, 0, width, height);
  sheet.slots.forEach((slot, index) => drawPanel(context, sheet, slot, index, thumbnailOf));
}

function drawPanel(
  context: CanvasRenderingContext2D,
  sheet: Sheet,
  { patch, coarse, older }: Slot,
  index: number,
  thumbnailOf: (photo: string) => Thumbnail | undefined,
) {
  const { document, geometry, width } = sheet;
  const ready = patch ?? coarse;
  if (ready) {
    const scale = width / ready.page;
    context.drawImage(ready.bitmap, ready.x * scale, ready.y * scale, ready.width * scale, ready.height * scale);
    return;
  }
  // A missing breakout is not an error while its mask is not ready.
  const panel = geometry.panels[index];
  if (!panel) return;
  context.save();
  trace(context, panel, width, document.page.cornerRadius);
  context.clip();
  context.fillStyle = 'rgb(128 128 136 / 0.16)';
  context.fill();
  const thumbnail = older ? undefined : thumbnailOf(document.panels[panelOf(document, index)].photo ?? '');
  if (thumbnail) drawThumbnail(context, thumbnail, shown(document, geometry, index).bounds, width);
  if (older) {
    drawOlder(context, sheet, older, index);
    context.strokeStyle = document.page.borderColor;
    // Half of the stroke is clipped away.
    context.lineWidth = 2 * document.page.border * width;
    if (document.page.border > 0) context.stroke();
  }
  context.restore();
}

/** Draws a thumbnail upright in the middle of a box, and covers all of the box. */
function drawThumbnail(
  context: CanvasRenderingContext2D,
  { bitmap, turn }: Thumbnail,
  box: { x: number; y: number; width: number; height: number },
  page: number,
) {
  const [wide, tall] = turn % 2 === 0 ? [box.width, box.height] : [box.height, box.width];
  const scale = page * Math.max(wide / bitmap.width, tall / bitmap.height);
  const [width, height] = [bitmap.width * scale, bitmap.height * scale];
  context.save();
  context.translate((box.x + box.width / 2) * page, (box.y + box.height / 2) * page);
  context.rotate((turn * Math.PI) / 2);
  context.drawImage(bitmap, -width / 2, -height / 2, width, height);
  context.restore();
}

/**
 * Draws an outdated picture. It is stretched to the panel. If only the crop was moved, the picture is also moved, over
 * the stretched one, which fills the part of the panel that it leaves.
 */
function drawOlder(
  context: CanvasRenderingContext2D,
  { document, geometry, width }: Sheet,
  older: Patch,
  index: number,
) {
  const { crop, bounds } = shown(document, geometry, index);
  const scale = width / older.page;
  const box = geometry.panels[index].bounds;
  context.drawImage(older.bitmap, box.x * width, box.y * width, box.width * width, box.height * width);
  if (crop && older.crop && JSON.stringify(bounds) === JSON.stringify(older.bounds)) {
    const [zoomX, zoomY] = [older.crop.width / crop.width, older.crop.height / crop.height];
    const left = (bounds.x + ((older.crop.x - crop.x) / crop.width) * bounds.width - bounds.x * zoomX) * width;
    const top = (bounds.y + ((older.crop.y - crop.y) / crop.height) * bounds.height - bounds.y * zoomY) * width;
    // Its border must not wander over the picture.
    const rim = Math.ceil(document.page.border * older.page) + 2;
    const [w, h] = [older.width - 2 * rim, older.height - 2 * rim];
    if (w < 1 || h < 1) return;
    context.drawImage(
      older.bitmap,
      rim,
      rim,
      w,
      h,
      left + (older.x + rim) * scale * zoomX,
      top + (older.y + rim) * scale * zoomY,
      w * scale * zoomX,
      h * scale * zoomY,
    );
  }
}

/** @param radius of the corners, in page widths */
function trace(
  context: CanvasRenderingContext2D,
  { polygon, circle }: Geometry['panels'][number],
  width: number,
  radius: number,
) {
  context.beginPath();
  if (circle) {
    context.arc(circle.x * width, circle.y * width, circle.radius * width, 0, 2 * Math.PI);
    return;
  }
  const points = (polygon ?? []).map(([x, y]) => [x * width, y * width] as [number, number]);
  if (points.length === 0) return;
  const [firstX, firstY] = middle(points[points.length - 1], points[0]);
  context.moveTo(firstX, firstY);
  points.forEach((point, i) => {
    const next = points[(i + 1) % points.length];
    context.arcTo(point[0], point[1], ...middle(point, next), Math.max(0, radius * width));
    context.lineTo(...middle(point, next));
  });
  context.closePath();
}

function middle(a: [number, number], b: [number, number]): [number, number] {
  return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}
