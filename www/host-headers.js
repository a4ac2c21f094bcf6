// @ts-check
/** Reads `_headers`, the file that defines the response headers of hosts. */

/**
 * @param {string} text of the file
 * @returns {Record<string, string>} the headers of all files (`/*`)
 */
export function headersOfAll(text) {
  /** @type {Record<string, string>} */
  const headers = {};
  let path = '';
  for (const line of text.split('\n')) {
    if (/^\s*(#|$)/.test(line)) continue;
    if (!/^\s/.test(line)) path = line.trim();
    else if (path === '/*') headers[line.slice(0, line.indexOf(':')).trim()] = line.slice(line.indexOf(':') + 1).trim();
  }
  return headers;
}
