/**
 * Translates names that the core and the data files have in English. A name without a translation stays English.
 */

export type Block = { id: string; label: string; help: string };
export type Parameter = { id: string; label: string; help?: string };

/** Translations by id, with a help text if the English name has one. */
export type Names = {
  /** Families of layouts and tags of styles. */
  families: Record<string, string>;
  /** Choices of parameters. */
  choices: Record<string, string>;
  /** A plain name with the technical term in brackets, and a help text. Default: the help text of the core. */
  blocks: Record<string, [string, string?]>;
  /** By block and parameter: `hue.angle`. */
  parameters: Record<string, [string, string]>;
  layouts: Record<string, string>;
  styles: Record<string, string>;
  /** The reasons of the core for selecting or excluding a photo. */
  verdicts: { same: (name: string) => string; sharpest: (of: string) => string; only: string; blurred: string };
};

const asName = (id: string) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

export function naming({ families, choices, blocks, parameters, layouts, styles, verdicts }: Names) {
  return {
    /** @param id of a family of layouts or a tag of styles */
    familyName: (id: string) => families[id] ?? asName(id),
    blockName: (block: Block) => blocks[block.id]?.[0] ?? block.label,
    blockHelp: (block: Block) => blocks[block.id]?.[1] ?? block.help,
    /** @param block id */
    parameterName: (block: string, parameter: Parameter) =>
      parameters[`${block}.${parameter.id}`]?.[0] ?? parameter.label,
    /** @param block id */
    parameterHelp: (block: string, parameter: Parameter) =>
      parameters[`${block}.${parameter.id}`]?.[1] ?? parameter.help ?? '',
    /** @param id of a choice of a parameter */
    choiceName: (id: string) => choices[id] ?? asName(id),
    verdict: (why: string) =>
      why
        .replace(/^same as (.*)$/s, (_, name) => verdicts.same(name))
        .replace(/^sharpest of (\d+)$/, (_, of) => verdicts.sharpest(of))
        .replace(/^only one like it$/, verdicts.only)
        .replace(/^blurred$/, verdicts.blurred),
    layoutTitle: (layout: { id: string; name: string }) => layouts[layout.id] ?? layout.name,
    styleTitle: (style: { id: string; name: string }) => styles[style.id] ?? style.name,
  };
}
