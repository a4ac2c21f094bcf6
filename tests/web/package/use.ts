/**
 * Valid and invalid use of the types in a TypeScript project. The compiler must reject each line with an error mark.
 */
import { createEngine, type Found, type PageDocument, type PixelPatch, type Style } from 'inkpanel';

const engine = createEngine({ workers: 2 });
const stop = new AbortController();

export async function use(photo: File, document: PageDocument): Promise<number> {
  const styles: Style[] = await engine.styles();
  const [block] = await engine.blocks();
  const least: number | undefined = block.params[0].min;
  const layouts: string[] = (await engine.layouts()).map(({ family }) => family);
  const data = new Uint8ClampedArray(4);
  const styled: PixelPatch = await engine.stylize(
    { width: 1, height: 1, data, style: styles[0] },
    { signal: stop.signal },
  );
  const found: Found[] = await engine.detect(photo, { signal: stop.signal });
  const chosen = await engine.select([photo], { duplicateThreshold: 8 });
  const kept: boolean = chosen[0].kept;
  const page = await engine.compose(document, { width: 800, photos: { a: photo }, signal: stop.signal });
  new ImageData(styled.data, styled.width, styled.height);
  // @ts-expect-error a style is an id or an object
  await engine.stylize({ width: 1, height: 1, data, style: 7 });
  // @ts-expect-error a width is needed
  await engine.compose(document, {});
  // @ts-expect-error there is no such field
  found[0].colour;
  // @ts-expect-error workers are a number
  createEngine({ workers: 'many' });
  engine.dispose();
  return page.width + found.length + layouts.length + (least ?? 0) + Number(kept);
}
