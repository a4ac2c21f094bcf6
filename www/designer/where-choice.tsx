/** Which part of the photo a layer or a block is for. */

import { strings } from '../strings/strings.ts';
import type { StylePart } from '../engine/types.ts';

const PARTS: readonly StylePart[] = ['subject', 'background'];

/** @param props `part`: null for the whole photo */
export function WhereChoice({
  label,
  part,
  onSet,
}: {
  label: string;
  part: StylePart | null;
  onSet: (part: StylePart | null) => void;
}) {
  return (
    <label class="parameter choice where" title={strings.whereHelp} data-set={part !== null}>
      <span class="parameter-name">{label}</span>
      <select
        class="select"
        value={part ?? ''}
        onChange={({ currentTarget: { value } }) => onSet(PARTS.find((known) => known === value) ?? null)}
      >
        <option value="">{strings.everywhere}</option>
        {PARTS.map((known) => (
          <option key={known} value={known}>
            {strings.wherePart[known]}
          </option>
        ))}
      </select>
    </label>
  );
}
