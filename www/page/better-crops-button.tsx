/** Offers crops that got better after the page was looked at. */

import { strings } from '../strings/strings.ts';
import { useApp } from '../app/context.ts';
import { Icon } from '../ui/icon.tsx';

export function BetterCrops() {
  const { crops } = useApp();
  if (crops.offered.value === null) return null;
  return (
    <button type="button" class="better-crops" title={strings.betterCropsWhy} onClick={crops.accept}>
      <Icon name="surprise" />
      <span>{strings.betterCrops}</span>
    </button>
  );
}
