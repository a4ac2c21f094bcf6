// @ts-check
/** Replaces texts in the files of a language, without other changes. */

import { bare, leavesOf, nameOf, readSource } from './source.js';

/** @typedef {import('./catalogue.js').Message} Message */
/** @typedef {import('./source.js').Source} Source */
/** @typedef {import('./po.js').Files} Files */

/** @param {string} text */
export const quoted = (text) => `'${text.replaceAll(/[\\']/g, '\\$&').replaceAll('\n', '\\n')}'`;

/** @param {string} text with places as `{name}` */
export function template(text) {
  const escaped = text.replaceAll(/[\\`]|\$(?=\{)/g, '\\$&').replaceAll('\n', '\\n');
  return /\{[^{}]*\}/.test(text) ? `\`${escaped.replaceAll(/\{([^{}]*)\}/g, '${$1}')}\`` : quoted(text);
}

/** How files begin that a new language does not have yet. */
const BEGINNINGS = new Map([
  [
    'names',
    `/** What the core and the data files call things, by their ids. */

import { blocks, parameters } from './blocks.ts';
import { layouts } from './layouts.ts';
import { styles } from './styles.ts';
import type { Names } from '../names.ts';

export const names: Names = {
  blocks,
  parameters,
  layouts,
  styles,
  families: {},
  choices: {},
  verdicts: {
    same: (name) => \`same as \${name}\`,
    sharpest: (of) => \`sharpest of \${of}\`,
    only: 'only one like it',
    blurred: 'blurred',
  },
};
`,
  ],
  [
    'blocks',
    `/** Names and help of the blocks, and of their settings. */

import type { Names } from '../names.ts';

export const blocks: Names['blocks'] = {};

export const parameters: Names['parameters'] = {};
`,
  ],
  ['layouts', '/** Names of the designed layouts. */\nexport const layouts: Record<string, string> = {};\n'],
  ['styles', '/** Names of the designed styles. */\nexport const styles: Record<string, string> = {};\n'],
]);

/**
 * Gives a new language the files that it has in any case, and the list of its areas.
 * @param {Files} files those that there are
 * @param {Map<string, Source>} english
 */
export function completeFolder(files, english) {
  for (const [file, text] of BEGINNINGS) if (!files.has(file)) files.set(file, text);
  if (files.has('index')) return;
  const areas = [...english.keys()].filter((file) => files.has(file) && !BEGINNINGS.has(file));
  const names = areas.map((file) =>
    [...(english.get(file)?.exported.keys() ?? [])].filter((name) => /Strings$/.test(name)),
  );
  const imports = areas.map((file, at) => `import { ${names[at].join(', ')} } from './${file}.ts';\n`).join('');
  const spread = names.flat().map((name) => `  ...${name},\n`);
  files.set(
    'index',
    `/** The page in another language; what is not in it is said in English. */

${imports}import type { PartOf } from '../partial.ts';
import type { Words } from '../en/index.ts';

export { names } from './names.ts';

export const words: PartOf<Words> = {
${spread.join('')}};
`,
  );
}

/**
 * @param {Files} files in which the sentence is put
 * @param {Message} message
 * @param {string} code
 * @param {Map<string, Source>} english
 * @returns {string} why it cannot be put there; empty where it is
 */
export function put(files, { file, key, english: { holes } }, code, english) {
  let text = files.get(file) ?? BEGINNINGS.get(file) ?? '';
  const needed = [];
  for (const hole of holes.filter((hole) => hole.includes('.') || english.get(file)?.imports.has(hole))) {
    const [root, ...path] = hole.split('.');
    const taken = english.get(file)?.taken.get(root);
    const imported = english.get(file)?.imports.get(taken?.of ?? root);
    // Part of a parameter.
    if (!imported) continue;
    const area = imported.from.slice(2, -3);
    const wanted = [imported.name, ...(taken ? [taken.name] : []), ...path].join('/');
    const there = files.get(area);
    const leaves = there ? leavesOf(readSource(there, `${area}.ts`)) : [];
    if (!leaves.some((leaf) => leaf.key.join('/') === wanted)) return `${area}/${wanted} has to be translated first`;
    needed.push({ name: taken?.of ?? root, statement: imported.statement });
    if (taken) needed.push({ name: root, statement: taken.statement });
  }
  const placed = place(text, file, key, code);
  if (placed === null) return 'what comes before it in its list has to be translated first';
  text = placed;
  for (const { name, statement } of needed) text = withStatement(text, file, name, statement);
  files.set(file, text);
  return '';
}

/**
 * @param {string} text
 * @param {string} file
 * @param {string[]} key
 * @param {string} code
 * @returns {string | null} the text with the code at that place, which is made where it is not
 */
function place(text, file, key, code) {
  const [name, ...path] = key;
  const source = readSource(text, `${file}.ts`);
  const found = source.exported.get(name);
  if (!found) {
    const made = built(path, code);
    return made && `${text}${text && '\n'}export const ${name} = ${made};\n`;
  }
  let node = bare(found);
  for (const [at, part] of path.entries()) {
    const rest = path.slice(at + 1);
    if (node.type === 'ArrayExpression') {
      const element = node.elements[Number(part)];
      if (element) {
        node = bare(element);
        continue;
      }
      const made = built(rest, code);
      return made === null || Number(part) !== node.elements.length ? null : appended(text, node, node.elements, made);
    }
    const property = node.properties.find((/** @type {any} */ one) => one.type === 'Property' && nameOf(one) === part);
    if (property) {
      node = bare(property.value);
      continue;
    }
    const made = built(rest, code);
    return made && appended(text, node, node.properties, `${keyed(part)}: ${made}`);
  }
  return text.slice(0, node.start) + code + text.slice(node.end);
}

/** @param {string} name of a property */
const keyed = (name) => (/^[A-Za-z_$][\w$]*$/.test(name) ? name : quoted(name));

/**
 * @param {string[]} path
 * @param {string} code
 * @returns {string | null} objects and lists down to it; nothing where a list would begin in its middle
 */
function built([part, ...rest], code) {
  if (part === undefined) return code;
  const inner = built(rest, code);
  if (inner === null || /^[1-9]\d*$/.test(part)) return null;
  return part === '0' ? `[${inner}]` : `{ ${keyed(part)}: ${inner} }`;
}

/**
 * @param {string} text
 * @param {any} node an object or a list
 * @param {any[]} members
 * @param {string} made the new last member
 */
function appended(text, node, members, made) {
  const last = members.at(-1);
  const end = node.end - 1;
  const comma = last && !/^\s*,/.test(text.slice(last.end, end)) ? ',' : '';
  const head = last ? text.slice(0, last.end) + comma + text.slice(last.end, end) : text.slice(0, end);
  return `${head}${made},${text.slice(end)}`;
}

/**
 * @param {string} text
 * @param {string} file
 * @param {string} name that the statement brings
 * @param {string} statement
 */
function withStatement(text, file, name, statement) {
  const { imports, taken } = readSource(text, `${file}.ts`);
  if (imports.has(name) || taken.has(name)) return text;
  // Behind the imports that there are, or in front of everything.
  const last = [...imports.values(), ...taken.values()].map(({ statement: one }) => text.indexOf(one) + one.length);
  const at = Math.max(0, ...last);
  return `${text.slice(0, at)}${at > 0 ? '\n' : ''}${statement}\n${text.slice(at)}`;
}
