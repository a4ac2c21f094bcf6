/** Extracts the English from files: blocks of Markdown, comments, strings and messages, with line numbers. */

/**
 * @typedef {{ line: number, text: string }} Line
 * @typedef {{ kind: 'markdown' | 'comment' | 'string' | 'cell', lines: Line[] }} Block
 */

/** A control in a guide. Bold text that ends in a full stop or a colon is not one. */
export const LABEL = /\*\*([^*\n]*[^*\n.:?])\*\*/g;

/**
 * @param {string} path relative to the top folder
 * @param {string} text
 * @returns {Block[]} the prose of a file, in file order
 */
export function prose(path, text) {
  const kind = /\.(\w+)$/.exec(path)?.[1] ?? '';
  switch (kind) {
    case 'md':
      // Guides print controls in bold, as the app names them.
      return markdown(numbered(path.startsWith('docs/guide/') ? text.replace(LABEL, '`control`') : text), 'markdown');
    case 'rs':
    case 'ts':
    case 'tsx':
    case 'js':
    case 'mjs':
    case 'css':
      return code(path, text, kind);
    case 'json':
      return messages(text);
    case 'py':
    case 'toml':
    case 'sh':
      return hashed(text);
    case 'yml':
      return path.startsWith('.github/ISSUE_TEMPLATE/') ? listed(text) : hashed(text);
    default:
      return [];
  }
}

/** @returns {Line[]} */
const numbered = (/** @type {string} */ text) => text.split('\n').map((line, i) => ({ line: i + 1, text: line }));

/**
 * Splits Markdown into paragraphs, list items, headings and table cells. Skips code.
 *
 * @param {Line[]} lines
 * @param {Block['kind']} kind
 * @returns {Block[]}
 */
function markdown(lines, kind) {
  /** @type {Block[]} */
  const blocks = [];
  /** @type {Line[]} */
  let block = [];
  let fence = '';
  let isComment = false;
  const end = () => {
    if (block.length > 0) blocks.push({ kind, lines: block });
    block = [];
  };
  for (const { line, text } of lines) {
    const mark = /^\s*(```+|~~~+)/.exec(text)?.[1] ?? '';
    if (fence !== '' || mark !== '') {
      end();
      if (fence === '') fence = mark;
      else if (mark.startsWith(fence)) fence = '';
      continue;
    }
    if (isComment || /^\s*<!--/.test(text)) {
      end();
      isComment = !text.includes('-->');
      continue;
    }
    if (/^\s*$/.test(text) || /^\s*\|?[\s:|-]+\|?\s*$/.test(text)) {
      end();
      continue;
    }
    // Indented code. Text of a list item continues a block or has less indent.
    if (block.length === 0 && /^ {4,}\S/.test(text) && !/^\s*(?:[-*+]|\d+\.) /.test(text)) continue;
    if (/^\s*\|/.test(text)) {
      end();
      for (const cell of text.split('|'))
        if (/[a-z]{2}/i.test(cell)) blocks.push({ kind: 'cell', lines: [{ line, text: cell }] });
      continue;
    }
    const item = /^\s*(?:(?:[-*+]|\d+\.)\s+|#+ |> ?)(.*)$/.exec(text);
    if (item !== null) {
      end();
      block.push({ line, text: item[1] });
      if (/^\s*#/.test(text)) end();
      continue;
    }
    block.push({ line, text });
  }
  end();
  return blocks;
}

/**
 * Extracts messages from a catalogue with one message per line.
 *
 * @param {string} text
 * @returns {Block[]}
 */
function messages(text) {
  return numbered(text).flatMap(({ line, text }) => {
    const message = /^\s*"[^"]+": (".*"),?$/.exec(text)?.[1];
    if (message === undefined) return [];
    return [{ kind: /** @type {const} */ ('string'), lines: [{ line, text: otherForm(JSON.parse(message)) }] }];
  });
}

/** @returns {string} a message of ICU MessageFormat with `code` for arguments, and with the form for other numbers */
function otherForm(/** @type {string} */ message) {
  const shorter = message
    .replaceAll(/\{\w+(?:, number[^{}]*)?\}/g, 'code')
    .replaceAll(/\{\w+, (?:plural|select),(?:\s*[=\w]+ \{[^{}]*\})*\s*other \{([^{}]*)\}\s*\}/g, '$1');
  return shorter === message ? message.replaceAll('#', 'code') : otherForm(shorter);
}

/** Whether a Rust string is a message: three words or more. */
const isSentence = (/** @type {string} */ text) =>
  (text.match(/[A-Za-z]{2,}/g)?.length ?? 0) >= 3 && / /.test(text.trim());

/**
 * Extracts comments, and the strings of the command line and of error messages.
 *
 * @param {string} path
 * @param {string} text
 * @param {string} kind
 * @returns {Block[]}
 */
function code(path, text, kind) {
  const { comments, strings } = scan(text, kind);
  const blocks = comments.flatMap((comment) => markdown(comment, 'comment'));
  const isProgram = kind === 'rs' && /^(?:src|crates\/[a-z]+\/src|python\/src|xtask\/src|wasm)\//.test(path);
  if (isProgram) {
    const tests = text.search(/#\[cfg\(test\)\]\s*mod \w+ \{/);
    const last = tests < 0 ? Number.POSITIVE_INFINITY : text.slice(0, tests).split('\n').length;
    for (const string of strings) {
      if (string.line > last || !isSentence(string.text)) continue;
      blocks.push({ kind: 'string', lines: [string] });
    }
  }
  return blocks.sort((a, b) => a.lines[0].line - b.lines[0].line);
}

/**
 * Scans a file in a language with C-style comments.
 *
 * @param {string} text
 * @param {string} kind
 * @returns {{ comments: Line[][], strings: Line[] }} adjacent line comments are one comment
 */
function scan(text, kind) {
  /** @type {Line[][]} */
  const comments = [];
  /** @type {Line[]} */
  const strings = [];
  const isRust = kind === 'rs';
  const isScript = !isRust && kind !== 'css';
  let line = 1;
  /** Line and opening mark of the last line comment. */
  let last = { line: -1, mark: '' };
  let at = 0;
  const lineOf = (/** @type {string} */ part) => part.split('\n').length - 1;
  /** Returns the end of a string, after the closing mark. */
  const closing = (/** @type {string} */ mark, /** @type {number} */ from) => {
    let i = from;
    while (i < text.length && text[i] !== mark) {
      if (text[i] === '\\') i += 1;
      else if (mark === '`' && text.startsWith('${', i)) i = bracket(i + 2);
      i += 1;
    }
    return Math.min(i + 1, text.length);
  };
  /** Returns the position of the closing bracket of an expression in a template. */
  const bracket = (/** @type {number} */ from) => {
    let depth = 1;
    let i = from;
    for (; i < text.length; i += 1) {
      const sign = text[i];
      if (sign === '{') depth += 1;
      else if (sign === '}') depth -= 1;
      else if (sign === "'" || sign === '"' || sign === '`') {
        const end = closing(sign, i + 1);
        strings.push({ line: line + lineOf(text.slice(at, i)), text: plain(text.slice(i + 1, end - 1)) });
        i = end - 1;
      }
      if (depth === 0) break;
    }
    return i;
  };
  while (at < text.length) {
    const rest = text.slice(at, at + 3);
    let end = at + 1;
    if (rest.startsWith('//') && kind !== 'css') {
      end = text.indexOf('\n', at);
      if (end < 0) end = text.length;
      const [, mark, said] = /^(\/\/[/!]?) ?(.*)$/.exec(text.slice(at, end)) ?? ['', '//', ''];
      const begins = text.slice(text.lastIndexOf('\n', at - 1) + 1, at).trim() === '';
      if (begins && last.line === line - 1 && last.mark === mark) comments.at(-1)?.push({ line, text: said });
      else comments.push([{ line, text: said }]);
      last = { line, mark };
    } else if (rest.startsWith('/*')) {
      end = text.indexOf('*/', at + 2) + 2;
      if (end < 2) end = text.length;
      comments.push(...tagged(text.slice(at + 2, end - 2), line));
    } else if (
      isRust &&
      /[br]/.test(text[at]) &&
      !/\w/.test(text[at - 1] ?? ' ') &&
      /^b?r#*"/.test(text.slice(at, at + 12))
    ) {
      const hashes = /^b?r(#*)"/.exec(text.slice(at, at + 12))?.[1] ?? '';
      const open = text.indexOf('"', at) + 1;
      end = text.indexOf(`"${hashes}`, open) + 1 + hashes.length;
      strings.push({ line, text: text.slice(open, end - 1 - hashes.length) });
    } else if (text[at] === '"' || (isScript && (text[at] === "'" || text[at] === '`'))) {
      end = closing(text[at], at + 1);
      strings.push({ line, text: plain(text.slice(at + 1, end - 1)) });
    } else if (isRust && text[at] === "'") {
      end = at + (/^'(?:\\(?:u\{\w+\}|x\w\w|.)|[^\\'])'/u.exec(text.slice(at, at + 14))?.[0].length ?? 1);
    } else if (
      isScript &&
      text[at] === '/' &&
      /(?:^|[([{,;:=!&|?+>]|\breturn|\bcase)\s*$/.test(text.slice(Math.max(0, at - 40), at))
    ) {
      end = at + (/^\/(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\[\n])+\//.exec(text.slice(at, at + 2000))?.[0].length ?? 1);
    }
    line += lineOf(text.slice(at, end));
    at = end;
  }
  return { comments, strings };
}

/** Returns the text of a string. A placeholder becomes one word, and example commands of the CLI help are left out. */
function plain(/** @type {string} */ text) {
  return text
    .replace(/^ {2}inkpanel .*$/gm, '')
    .replace(/\$\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}/g, 'code')
    .replace(/\\n|\\\n\s*/g, ' ')
    .replace(/\\(.)/g, '$1')
    .replace(/\{[^{}]*\}/g, 'code');
}

/**
 * Splits a block comment into its text and its tags.
 *
 * @param {string} text
 * @param {number} first
 * @returns {Line[][]}
 */
function tagged(text, first) {
  /** @type {Line[][]} */
  const parts = [[]];
  for (const [i, whole] of text.split('\n').entries()) {
    const said = whole.replace(/^\s*\*+ ?/, '').replace(/^\*/, '');
    const tag = /^\s*@(\w+)\s*(?:\{(?:[^{}]|\{[^{}]*\})*\})?\s*(.*)$/.exec(said);
    if (tag !== null) {
      const isNamed = /^(?:param|property|typedef|template)$/.test(tag[1]);
      parts.push([{ line: first + i, text: isNamed ? tag[2].replace(/^\[?[\w.$]+(?:=[^\]]*)?\]?\s*/, '') : tag[2] }]);
    } else {
      parts.at(-1)?.push({ line: first + i, text: said });
    }
  }
  return parts;
}

/** Extracts comments after a hash, and triple-quoted strings. */
function hashed(/** @type {string} */ text) {
  /** @type {Block[]} */
  const blocks = [];
  /** @type {Line[]} */
  let block = [];
  /** @type {Line[] | null} */
  let long = null;
  /** Indentation of the last triple-quoted string. */
  let indent = 0;
  const end = () => {
    blocks.push(...markdown(block, 'comment'));
    block = [];
  };
  for (const { line, text: whole } of numbered(text)) {
    const quotes = whole.split('"""').length - 1;
    if (long !== null || quotes > 0) {
      end();
      const said = long === null ? whole.slice(whole.indexOf('"""') + 3) : whole;
      if (long === null) indent = /^ */.exec(whole)?.[0].length ?? 0;
      const text = said.replace('"""', '').replace(new RegExp(`^ {${indent}}`), '');
      // The description of each argument is a block.
      long = [...(long ?? []), { line, text: text.replace(/^(\w+(?:, \w+)*: )/, '- $1') }];
      if (quotes === 2 || (quotes === 1 && said !== whole.slice(whole.indexOf('"""') + 3))) {
        blocks.push(...markdown(long, 'comment'));
        long = null;
      } else if (quotes === 1 && long.length > 1) {
        blocks.push(...markdown(long, 'comment'));
        long = null;
      }
      continue;
    }
    const said = /^\s*# ?(.*)$/.exec(whole)?.[1] ?? /\s# (.*)$/.exec(whole)?.[1];
    if (said === undefined || whole.startsWith('#!')) {
      end();
      continue;
    }
    if (!/^\s*#/.test(whole)) end();
    block.push({ line, text: said });
  }
  end();
  return blocks;
}

/** Extracts the texts of an issue form. */
function listed(/** @type {string} */ text) {
  /** @type {Block[]} */
  const blocks = [];
  for (const { line, text: whole } of numbered(text)) {
    const said = /^\s*(?:- )?(?:name|description|label|placeholder|value|about): (.*)$/.exec(whole)?.[1];
    if (said !== undefined) blocks.push({ kind: 'string', lines: [{ line, text: said }] });
  }
  return blocks;
}

/**
 * Splits a block into sentences with line numbers. Inline code and URLs become one word.
 *
 * @param {Block} block
 * @returns {(Line & { isList: boolean })[]} a list in a table cell has no limit of words
 */
export function sentences({ lines, kind }) {
  const text = lines.map((line) => line.text).join('\n');
  const plainText = text
    .replace(/`+[^`]*`+/g, (code) => `code${'\n'.repeat(code.split('\n').length - 1)}`)
    .replace(/!?\[([^\]]*)\]\([^)]*\)/g, '$1')
    .replace(/\[([^\]]*)\]\[[^\]]*\]/g, '$1')
    .replace(/<\/?[a-zA-Z][^>]*>/g, '')
    .replace(/\bhttps?:\/\/\S+/g, 'code')
    .replace(kind === 'markdown' || kind === 'cell' ? /\*+/g : /\*\*/g, '');
  /** @type {(Line & { isList: boolean })[]} */
  const found = [];
  let at = 0;
  for (const part of plainText.split(/(?<=[.!?]["”)]?)\s+(?=["“(]?(?:[A-Z0-9]|code))/u)) {
    const before = plainText.slice(0, plainText.indexOf(part, at)).split('\n').length - 1;
    at = plainText.indexOf(part, at) + part.length;
    const text = part.replace(/\s+/g, ' ').trim();
    const isList = kind === 'cell' && 4 * (text.match(/[,;]/g)?.length ?? 0) >= words(text);
    if (text !== '') found.push({ line: lines[Math.min(before, lines.length - 1)].line, text, isList });
  }
  return found;
}

/** Counts the words of a text. */
export const words = (/** @type {string} */ text) => text.match(/\p{L}[\p{L}\p{N}'’-]*/gu)?.length ?? 0;
