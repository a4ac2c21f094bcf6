/**
 * Translates names that the core and the data files have in English. A name without a translation stays English.
 */

import type { VerdictReason } from '../engine/types.ts';

export type Block = { id: string; label: string; plain?: string; help: string };
export type Parameter = { id: string; label: string; help?: string };

type Texts = Readonly<Record<string, string>>;

/** Translations by id: a file of `names/`. The app does not load the English file, because the core and the data files are English. */
export type Names = {
  /** Families of layouts and tags of styles. */
  families: Texts;
  /** Choices of parameters. */
  choices: Texts;
  /** A plain name with the technical term in brackets. */
  blockNames: Texts;
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
  choices: Texts;
  /** The reasons of the core for selecting or excluding a photo. */
  verdicts: {
    same: (named: { name: string }) => string;
    sharpest: (counted: { of: string }) => string;
    awake: (counted: { of: string }) => string;
    only: string;
    blurred: string;
    frame: string;
  };
};

const withoutHyphens = (title: string) => title.replaceAll('\u00ad', '');

const asName = (id: string) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

/** @param names missing in English */
export function naming({ choices, verdicts }: Named, names: Partial<Names> = {}) {
  /** Titles with soft hyphens, for narrow tiles: not every browser hyphenates every language. */
  const layoutTile = (layout: { id: string; name: string }) => names.layouts?.[layout.id] ?? layout.name;
  const styleTile = (style: { id: string; name: string }) => names.styles?.[style.id] ?? style.name;
  const parameterOf = (block: string, { id }: Parameter) => names.parameters?.[block]?.[id];
  return {
    /** @param id of a family of layouts or a tag of styles */
    familyName: (id: string) => names.families?.[id] ?? asName(id),
    blockName: ({ id, label, plain }: Block) => names.blockNames?.[id] ?? (plain ? `${plain} (${label})` : label),
    blockHelp: (block: Block) => names.blockHelp?.[block.id] ?? block.help,
    /** @param block id */
    parameterName: (block: string, parameter: Parameter) => parameterOf(block, parameter)?.name ?? parameter.label,
    /** @param block id */
    parameterHelp: (block: string, parameter: Parameter) => parameterOf(block, parameter)?.help ?? parameter.help ?? '',
    /** @param id of a choice of a parameter */
    choiceName: (id: string) => choices[id] ?? names.choices?.[id] ?? asName(id),
    verdict: (reason: VerdictReason) => {
      switch (reason.code) {
        case 'same-as':
          return verdicts.same({ name: reason.name });
        case 'sharpest':
          return verdicts.sharpest({ of: String(reason.of) });
        case 'open-eyes':
          return verdicts.awake({ of: String(reason.of) });
        case 'only':
          return verdicts.only;
        case 'blurred':
          return verdicts.blurred;
        case 'frame':
          return verdicts.frame;
      }
    },
    /** @returns a sentence for an error of the core, or undefined in English */
    coreReason: (code: string) => names.reasons?.[code],
    layoutTitle: (layout: { id: string; name: string }) => withoutHyphens(layoutTile(layout)),
    styleTitle: (style: { id: string; name: string }) => withoutHyphens(styleTile(style)),
    layoutTile,
    styleTile,
  };
}
