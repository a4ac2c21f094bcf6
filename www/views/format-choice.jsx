// @ts-check
import { useEffect, useState } from 'preact/hooks';
import { isArchive } from '../state/formats.js';
import { strings } from '../strings.js';
import { useApp } from './context.js';

/** @typedef {import('../state/formats.js').Format} Format */
/** @typedef {import('../state/formats.js').Inside} Inside */

/**
 * The kind of file, and of the pictures in it where it is an archive. WebP is offered where the browser makes it.
 * @param {{ formats: readonly Format[], format: Format, choose: (format: Format) => void, inside: Inside, chooseInside: (inside: Inside) => void }} props
 */
export function FormatChoice({ formats, format, choose, inside, chooseInside }) {
  const { engine } = useApp();
  const [webp, setWebp] = useState(false);
  useEffect(() => {
    engine.givesWebp().then(setWebp);
  }, []);
  return (
    <>
      <label class="field">
        <span>{strings.format}</span>
        <select class="select" value={format} onChange={(event) => choose(/** @type {Format} */ (event.currentTarget.value))}>
          {formats.filter((id) => id !== 'webp' || webp).map((id) => <option key={id} value={id}>{strings.formats[id]}</option>)}
        </select>
      </label>
      {isArchive(format) && (
        <label class="field">
          <span>{strings.pictures}</span>
          <select class="select" value={inside} onChange={(event) => chooseInside(/** @type {Inside} */ (event.currentTarget.value))}>
            <option value="png">{strings.insides.png}</option>
            <option value="jpeg">{strings.insides.jpeg}</option>
          </select>
        </label>
      )}
    </>
  );
}
