/** The safe area as a line on the page. Exported files do not contain it. */

import type { PageSettings } from '../engine/types.ts';
import { safeArea } from './paper.ts';

/** @param settings of its page */
export function SafeArea({ settings }: { settings: PageSettings }) {
  const { width, height } = settings;
  const { across, down, fold } = safeArea(settings);
  return (
    <svg class="safe-area" viewBox={`0 0 ${width} ${height}`} aria-hidden="true">
      <path
        class="unsafe"
        fill-rule="evenodd"
        d={`M0 0H${width}V${height}H0Z M${across} ${down}V${height - down}H${width - across}V${down}Z`}
      />
      <rect x={across} y={down} width={width - 2 * across} height={height - 2 * down} />
      {fold > 0 && <rect x={width / 2 - fold} y={0} width={2 * fold} height={height} />}
    </svg>
  );
}
