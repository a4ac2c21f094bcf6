/** How large a page is as a file, by encoding it small. */

import { Priority } from './queue.ts';
import { givesWebp } from './webp.ts';
import type { PageDocument } from './types.ts';
import type { createFiles } from './files.ts';
import type { Run } from './pool.ts';
import type { createRenders } from './renders.ts';

export type PictureFormat = 'png' | 'jpeg' | 'webp';

export function createMeasures({
  run,
  renders,
  files,
}: {
  run: Run;
  renders: Pick<ReturnType<typeof createRenders>, 'composePixels'>;
  files: ReturnType<typeof createFiles>;
}) {
  return { measureFile };

  /**
   * @param wish `width` of the page in pixels
   * @returns the size of the file and of its image
   */
  async function measureFile(
    document: PageDocument,
    { width, format, quality, signal }: { width: number; format: PictureFormat; quality: number; signal?: AbortSignal },
  ): Promise<{ bytes: number; pixels: number }> {
    const page = await renders.composePixels(document, width, { signal });
    const pixels = page.width * page.height;
    if (format === 'jpeg')
      return { bytes: (await files.jpeg(document, page, [page], quality, { signal })).size, pixels };
    if (format === 'webp' && !(await givesWebp()))
      return { bytes: (await files.losslessWebp(document, page, [page], { signal })).size, pixels };
    const args = { document: JSON.stringify(document), width, patches: [{ ...page, index: 0 }] };
    const png = await run({ op: 'encode', args, transfer: [page.data.buffer], priority: Priority.PAGE, signal });
    const file = format === 'png' ? png : await files.webp(png, { quality, dpi: document.page.dpi }, { signal });
    return { bytes: file.size, pixels };
  }
}
