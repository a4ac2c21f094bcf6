/** Names of exported files: the project name, and the page number if there are several pages. */

import { strings } from '../strings/strings.ts';
import { fileNameOf } from '../ui/file-name.ts';
import { FORMATS } from './formats.ts';
import type { Project } from '../document/project.ts';
import type { Format } from './formats.ts';

type Named = Pick<Project, 'name' | 'at' | 'others'>;

/**
 * @param project its page that is being edited is the one that is exported separately
 * @param count of the pages in the file
 * @param forPrint so that it does not replace a PDF file for screens
 */
export function fileName(project: Named, count: number, format: Format, forPrint = false): string {
  const parts = [project.name, count > 1 ? '' : pagePart(project), forPrint ? strings.filePrint : ''];
  return fileNameOf(parts, FORMATS[format].ending, strings.untitled);
}

/** @param index from 0 */
export function panelName(project: Named, index: number): string {
  return fileNameOf([project.name, pagePart(project), strings.filePanel({ n: index + 1 })], 'png', strings.untitled);
}

function pagePart({ at, others }: Named): string {
  return others.length > 0 ? strings.filePage({ n: at + 1 }) : '';
}
