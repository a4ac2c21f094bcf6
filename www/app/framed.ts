/**
 * A page of another site could hold this one in a frame, and have people press what they do not see. Hosts forbid
 * framing by a header (`public/_headers`). A page cannot set this header, so it refuses to run in a frame. The first
 * import of `main.tsx`: if this module throws, the app does not start.
 */

import { strings } from '../strings/strings.ts';

if (typeof window !== 'undefined' && isFramedByOthers(window)) {
  refuse(document);
  throw new Error('Inkpanel does not work in a page of another site.');
}

/** @returns whether any of the pages around it is of another origin */
export function isFramedByOthers(inner: Window): boolean {
  try {
    // Browsers block access to a page of another origin.
    for (let at = inner; at.parent !== at; at = at.parent) void at.parent.document;
    return false;
  } catch {
    return true;
  }
}

/** Shows an explanation, with a link that opens the app in a new tab. */
function refuse(document: Document) {
  const make = (tag: string, fields: object) => Object.assign(document.createElement(tag), fields);
  const main = make('main', { className: 'framed' });
  const link = make('a', {
    className: 'button',
    href: document.location.href,
    target: '_blank',
    rel: 'noopener',
    textContent: strings.openInTab,
  });
  main.append(make('h1', { textContent: strings.name }), make('p', { textContent: strings.framed }), link);
  document.getElementById('app')?.replaceChildren(main);
}
