import { isArchive, isBook } from './formats.ts';
import { strings } from '../strings/strings.ts';
import type { Inside, Way } from './formats.ts';

/** The kind of file, and of the pictures in it where it is an archive. */
export function FormatChoice({
  formats,
  format,
  choose,
  inside,
  chooseInside,
}: {
  formats: readonly Way[];
  format: Way;
  choose: (format: Way) => void;
  inside: Inside;
  chooseInside: (inside: Inside) => void;
}) {
  return (
    <>
      <label class="field">
        <span>{strings.format}</span>
        <select
          class="select"
          value={format}
          aria-describedby={isBook(format) ? 'book-help' : undefined}
          onChange={(event) => choose(event.currentTarget.value as Way)}
        >
          {formats.map((id) => (
            <option key={id} value={id}>
              {strings.formats[id]}
            </option>
          ))}
        </select>
      </label>
      {isBook(format) && (
        <p class="quiet" id="book-help">
          {strings.bookHelp[format]}
        </p>
      )}
      {isArchive(format) && (
        <label class="field">
          <span>{strings.pictures}</span>
          <select class="select" value={inside} onChange={(event) => chooseInside(event.currentTarget.value as Inside)}>
            <option value="png">{strings.insides.png}</option>
            <option value="jpeg">{strings.insides.jpeg}</option>
          </select>
        </label>
      )}
    </>
  );
}
