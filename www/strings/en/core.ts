/** Names that the core and the data files bring along. They are English there, so here they pass as they are. */

export type Block = { id: string; label: string; help: string };
export type Parameter = { id: string; label: string; help?: string };

const asName = (id: string) => id.charAt(0).toUpperCase() + id.slice(1).replaceAll(/[-_]/g, ' ');

export const coreStrings = {
  /** @param id of a family of layouts or a tag of styles */
  familyName: (id: string) => asName(id),
  blockName: (block: Block) => block.label,
  blockHelp: (block: Block) => block.help,
  /** @param _block id */
  parameterName: (_block: string, parameter: Parameter) => parameter.label,
  /** @param _block id */
  parameterHelp: (_block: string, parameter: Parameter) => parameter.help ?? '',
  /** @param id of a choice of a parameter */
  choiceName: (id: string) => asName(id),
  /** Why a photo is kept or set aside. */
  verdict: (why: string) => why,
  layoutTitle: (layout: { id: string; name: string }) => layout.name,
  styleTitle: (style: { id: string; name: string }) => style.name,
};
