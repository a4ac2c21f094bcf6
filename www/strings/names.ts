/**
 * Translates names that the core and the data files have in English. A name without a translation stays English.
 */

export type Block = { id: string; label: string; help: string };
export type Parameter = { id: string; label: string; help?: string };

type Texts = Readonly<Record<string, string>>;

/** Translations by id: a file of `names/`. The app does not load the English file, because the core and the data files are English. */
export type Names = {
  /** Families of layouts and tags of styles. */
  families: Texts;
  /** Choices of parameters. */
  choices: Texts;
  blockHelp: Texts;
  /** By block and parameter. */
  parameters: Readonly<Record<string, Readonly<Record<string, { name: string; help: string }>>>>;
  layouts: Texts;
  styles: Texts;
  /** Sentences for error codes, in place of the core's English messages, which say more. */
  reasons: Texts;
};

/** Messages that name things of the core. */
type Named = {
  /** A plain name with the technical term in brackets. */
  blockNames: Texts;
  choices: Texts;
  /** The reasons of the core for selecting or excluding a photo. */
  verdicts: {
    same: (named: { name: string }) => string;
    sharpest: (counted: { of: string }) => string;
    awake: (counted: { of: string }) => string;
    only: string;
    blurred: string;
  };
};

const asName = (id: string) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

/** @param names missing in English */
export function naming({ blockNames, choices, verdicts }: Named, names: Partial<Names> = {}) {
  const parameterOf = (block: string, { id }: Parameter) => names.parameters?.[block]?.[id];
  return {
    /** @param id of a family of layouts or a tag of styles */
    familyName: (id: string) => names.families?.[id] ?? asName(id),
    blockName: (block: Block) => blockNames[block.id] ?? block.label,
    blockHelp: (block: Block) => names.blockHelp?.[block.id] ?? block.help,
    /** @param block id */
    parameterName: (block: string, parameter: Parameter) => parameterOf(block, parameter)?.name ?? parameter.label,
    /** @param block id */
    parameterHelp: (block: string, parameter: Parameter) => parameterOf(block, parameter)?.help ?? parameter.help ?? '',
    /** @param id of a choice of a parameter */
    choiceName: (id: string) => choices[id] ?? names.choices?.[id] ?? asName(id),
    verdict: (why: string) =>
      why
        .replace(/^same as (.*)$/s, (_, name) => verdicts.same({ name }))
        .replace(/^sharpest of (\d+)$/, (_, of) => verdicts.sharpest({ of }))
        .replace(/^open eyes, best of (\d+)$/, (_, of) => verdicts.awake({ of }))
        .replace(/^only one like it$/, verdicts.only)
        .replace(/^blurred$/, verdicts.blurred),
    /** @returns a sentence for an error of the core, or undefined in English */
    coreReason: (code: string) => names.reasons?.[code],
    layoutTitle: (layout: { id: string; name: string }) => names.layouts?.[layout.id] ?? layout.name,
    styleTitle: (style: { id: string; name: string }) => names.styles?.[style.id] ?? style.name,
  };
}
