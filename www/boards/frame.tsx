/** A photo as a frame of the board: in its aspect and in the style of the page, small. */

import { styleOfPage } from '../styles/style-actions.ts';
import { Bitmap } from '../ui/bitmap.tsx';
import { useApp } from '../ui/context.ts';
import { ASPECTS } from './shots.ts';

/** Width of a picture in pixels, for screens of two a CSS pixel. */
const WIDTH = 192;

export function Frame({ id }: { id: string }) {
  const app = useApp();
  const { boards, store, engine } = app;
  const aspect = ASPECTS[boards.board.value.aspect] ?? 16 / 9;
  const meta = store.album.value.get(id)?.meta;
  const style = styleOfPage(app);
  if (!meta || !style || !engine.hasPhoto(id)) return <span class="bitmap" style={{ aspectRatio: aspect }} />;
  const [framed] = store.planner.value?.frames(store.photos.value, [id], aspect) ?? [];
  const size = {
    width: Math.round(WIDTH * Math.min(1, aspect)),
    height: Math.round((WIDTH * Math.min(1, aspect)) / aspect),
  };
  return (
    <span class="shot-frame" style={{ aspectRatio: aspect }}>
      <Bitmap
        of={`${id} ${aspect} ${style.id} ${JSON.stringify(framed?.crop)}`}
        draw={(call) => engine.stylePhoto(id, style, { ...size, crop: framed?.crop ?? null }, call)}
      />
    </span>
  );
}
