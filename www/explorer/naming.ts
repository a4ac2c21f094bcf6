/** Names of generated styles, with their colour. Two styles never share a name. */

import type { Hue, Lightness } from './colours.ts';

/** By lightness: dark, middle, light. */
const COLOURS: Record<Hue, Record<Lightness, string>> = {
  red: { dark: 'Maroon', middle: 'Crimson', light: 'Coral' },
  orange: { dark: 'Rust', middle: 'Amber', light: 'Apricot' },
  yellow: { dark: 'Mustard', middle: 'Golden', light: 'Lemon' },
  green: { dark: 'Forest', middle: 'Green', light: 'Mint' },
  cyan: { dark: 'Petrol', middle: 'Teal', light: 'Aqua' },
  blue: { dark: 'Navy', middle: 'Blue', light: 'Sky' },
  purple: { dark: 'Plum', middle: 'Violet', light: 'Lilac' },
  pink: { dark: 'Berry', middle: 'Magenta', light: 'Pink' },
  mixed: { dark: 'Night', middle: 'Colour', light: 'Bright' },
  gray: { dark: 'Charcoal', middle: 'Grey', light: 'Silver' },
};

/**
 * Returns a name for a style.
 * @param name generated name, whose last word is preserved
 */
export function colourName(name: string, hue: Hue, lightness: Lightness, taken: (name: string) => boolean): string {
  const kind = name.split(' ').at(-1) ?? '';
  const plain = `${COLOURS[hue][lightness]} ${kind}`.trim();
  for (let number = 1; ; number += 1) {
    const numbered = number === 1 ? plain : `${plain} ${number}`;
    if (!taken(numbered)) return numbered;
  }
}
