// @ts-check
/** Reads the texts in a file of `strings/`: every text with its path, including functions of numbers and names. */

import { parseSync } from 'vite';

/**
 * A node of the syntax tree. Its fields depend on its type.
 * @typedef {any} Node
 * @typedef {{ text: string, declared: Map<string, Node>, exported: Map<string, Node>, imports: Map<string, Import>, taken: Map<string, Taken> }} Source
 * @typedef {{ from: string, name: string, statement: string }} Import
 * @typedef {{ of: string, name: string, statement: string }} Taken a part of something imported, under its own name
 * @typedef {{ key: string[], node: Node }} Leaf
 */

/**
 * The parts of a text: literal texts, and code for the placeholders between them.
 * @typedef {(string | { hole: string })[]} Parts
 */

/**
 * A text in its general form.
 * @typedef {{ one: string, many: string, holes: string[], count: string | null, condition: string | null, parameters: string | null, literal: boolean }} Sentence
 */

/**
 * @param {string} text of a file
 * @param {string} name of it, for the message
 * @returns {Source}
 */
export function readSource(text, name) {
  const { program, errors } = parseSync(name, text);
  if (errors.length > 0) throw new Error(`${name}: ${errors[0].message}`);
  /** @type {Source} */
  const source = { text, declared: new Map(), exported: new Map(), imports: new Map(), taken: new Map() };
  for (const statement of /** @type {Node[]} */ (program.body)) {
    if (statement.type === 'ImportDeclaration' && statement.importKind !== 'type') {
      for (const { local, imported } of statement.specifiers) {
        const from = statement.source.value;
        const told = text.slice(statement.start, statement.end);
        source.imports.set(local.name, { from, name: imported?.name ?? local.name, statement: told });
      }
    }
    const declaration = statement.declaration ?? statement;
    if (declaration.type === 'FunctionDeclaration') source.declared.set(declaration.id.name, declaration);
    if (declaration.type !== 'VariableDeclaration') continue;
    for (const { id, init } of declaration.declarations) {
      if (id.type === 'ObjectPattern' && init.type === 'Identifier') {
        const told = text.slice(statement.start, statement.end);
        for (const part of id.properties) {
          source.taken.set(part.value.name, { of: init.name, name: nameOf(part), statement: told });
        }
      }
      if (id.type !== 'Identifier') continue;
      source.declared.set(id.name, init);
      if (statement.type === 'ExportNamedDeclaration') source.exported.set(id.name, init);
    }
  }
  return source;
}

/**
 * Removes brackets and type annotations.
 * @param {Node} node
 * @returns {Node}
 */
export function bare(node) {
  const around = ['TSAsExpression', 'TSSatisfiesExpression', 'ParenthesizedExpression'];
  return around.includes(node.type) ? bare(node.expression) : node;
}

/** @param {Node} property of an object */
export const nameOf = ({ key }) => (key.type === 'Identifier' ? key.name : String(key.value));

/**
 * @param {Source} source
 * @returns {Leaf[]} everything that is neither an object nor a list, by its export and its path there
 */
export function leavesOf(source) {
  /** @type {(node: Node, key: string[]) => Leaf[]} */
  const below = (node, key) => {
    const inner = bare(node);
    if (inner.type === 'ObjectExpression') {
      const own = inner.properties.filter((/** @type {Node} */ { type }) => type === 'Property');
      return own.flatMap((/** @type {Node} */ property) => below(property.value, [...key, nameOf(property)]));
    }
    if (inner.type === 'ArrayExpression') {
      return inner.elements.flatMap((/** @type {Node} */ element, /** @type {number} */ at) =>
        below(element, [...key, String(at)]),
      );
    }
    // Strings of another file under their own name.
    return inner.type === 'Identifier' ? [] : [{ key, node: inner }];
  };
  return [...source.exported].flatMap(([name, node]) => below(node, [name]));
}

/** Thrown if a text needs code. */
class Code extends Error {}

/** Numbers for testing the ranges of a condition. */
const MANY = [2, 3, 7, 100];

/** @type {Record<string, (a: number, b: number) => boolean>} */
const COMPARED = {
  '===': (a, b) => a === b,
  '!==': (a, b) => a !== b,
  '<': (a, b) => a < b,
  '<=': (a, b) => a <= b,
  '>': (a, b) => a > b,
  '>=': (a, b) => a >= b,
};

/**
 * @param {Source} source
 * @param {Node} node a leaf of it
 * @returns {Sentence | null} null if the text needs code
 */
export function sentenceOf(source, node) {
  const isFunction = node.type === 'ArrowFunctionExpression';
  const body = isFunction ? node.body : node;
  /** @type {{ count: string | null, condition: string | null }} */
  const seen = { count: null, condition: null };
  try {
    if (body.type === 'BlockStatement') throw new Code();
    /** @type {Map<string, Parts>} */
    const bound = new Map();
    for (const parameter of isFunction ? node.params : []) {
      for (const name of namesIn(parameter)) bound.set(name, [{ hole: name }]);
    }
    const [one, many] = [true, false].map((single) => evaluate(source, body, bound, single, seen));
    const holes = [...new Set([...one, ...many].flatMap((part) => (typeof part === 'string' ? [] : [part.hole])))];
    const texts = [...one, ...many].filter((part) => typeof part === 'string');
    // A bracket in the text itself would be taken for a place of something.
    if ((holes.length > 0 || seen.count) && texts.some((text) => /[{}]/.test(text))) throw new Code();
    // A translator could not understand a placeholder with text or code.
    if (holes.some((hole) => !/^[a-z][\w.]*$/i.test(hole))) throw new Code();
    const parameters = isFunction
      ? source.text.slice(node.start, source.text.indexOf('=>', lastEnd(node))).trim()
      : null;
    return { ...seen, one: told(one), many: told(many), holes, parameters, literal: !isFunction && holes.length === 0 };
  } catch (error) {
    if (error instanceof Code) return null;
    throw error;
  }
}

/** @param {Node} node of a function; where its parameters end */
const lastEnd = ({ params, returnType, start }) => returnType?.end ?? params.at(-1)?.end ?? start;

/** @param {Parts} parts */
const told = (parts) => parts.map((part) => (typeof part === 'string' ? part : `{${part.hole}}`)).join('');

/**
 * @param {Node} parameter
 * @returns {string[]} its name, or the names of its parts
 */
function namesIn(parameter) {
  if (parameter.type === 'Identifier') return [parameter.name];
  if (parameter.type !== 'ObjectPattern') throw new Code();
  return parameter.properties.map((/** @type {Node} */ { value }) => {
    if (value?.type !== 'Identifier') throw new Code();
    return value.name;
  });
}

/**
 * Evaluates an expression for one thing or for many.
 * @param {Source} source
 * @param {Node} expression
 * @param {Map<string, Parts>} bound the values of names
 * @param {boolean} single
 * @param {{ count: string | null, condition: string | null }} seen the placeholder of the count, and the condition for
 * the singular
 * @returns {Parts}
 */
function evaluate(source, expression, bound, single, seen) {
  const node = bare(expression);
  /** @param {Node} inner */
  const inside = (inner) => evaluate(source, inner, bound, single, seen);
  switch (node.type) {
    case 'Literal':
      if (typeof node.value !== 'string') throw new Code();
      return [node.value];
    case 'TemplateLiteral':
      return node.quasis.flatMap((/** @type {Node} */ { value }, /** @type {number} */ at) =>
        at === 0 ? [value.cooked] : [...inside(node.expressions[at - 1]), value.cooked],
      );
    case 'Identifier': {
      const known = bound.get(node.name);
      if (known) return known;
      const declared = source.declared.get(node.name);
      if (declared && ['Literal', 'TemplateLiteral'].includes(bare(declared).type)) return inside(declared);
      if (!source.imports.has(node.name)) throw new Code();
      return [{ hole: node.name }];
    }
    case 'MemberExpression': {
      if (node.computed) throw new Code();
      const code = source.text.slice(node.start, node.end);
      const root = /^\w+/.exec(code)?.[0] ?? '';
      const known = bound.get(root);
      if (!known) return [{ hole: code }];
      if (known.length !== 1 || typeof known[0] === 'string') throw new Code();
      return [{ hole: known[0].hole + code.slice(root.length) }];
    }
    case 'ConditionalExpression': {
      const { left, right, operator } = node.test;
      const compare = COMPARED[operator];
      if (node.test.type !== 'BinaryExpression' || !compare || typeof right.value !== 'number') throw new Code();
      const [counted] = inside(left);
      const truths = new Set(MANY.map((many) => compare(many, right.value)));
      if (typeof counted === 'string' || truths.size > 1 || truths.has(compare(1, right.value))) throw new Code();
      if (seen.count !== null && seen.count !== counted.hole) throw new Code();
      const single0 = compare(0, right.value) === compare(1, right.value);
      seen.count = counted.hole;
      seen.condition = single0 ? '< 2' : '=== 1';
      return inside(compare(single ? 1 : 2, right.value) ? node.consequent : node.alternate);
    }
    case 'CallExpression': {
      const called = node.callee.type === 'Identifier' ? source.declared.get(node.callee.name) : null;
      if (called?.type !== 'ArrowFunctionExpression' || called.body.type === 'BlockStatement') throw new Code();
      const names = called.params.flatMap(namesIn);
      if (names.length !== node.arguments.length) throw new Code();
      const values = new Map(
        names.map((/** @type {string} */ name, /** @type {number} */ at) => [name, inside(node.arguments[at])]),
      );
      return evaluate(source, called.body, values, single, seen);
    }
    default:
      throw new Code();
  }
}
