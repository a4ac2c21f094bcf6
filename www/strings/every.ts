/** What is written alike in every language. */

/** @returns minutes and seconds, and hours where there are any: `1:02:03.4` */
function clock(seconds: number): string {
  const tenths = Math.round(seconds * 10);
  const [hours, minutes, rest] = [Math.floor(tenths / 36_000), Math.floor(tenths / 600) % 60, (tenths % 600) / 10];
  const two = (value: number, digits = 0) => value.toFixed(digits).padStart(digits ? 4 : 2, '0');
  return `${hours ? `${hours}:${two(minutes)}` : minutes}:${two(rest, 1)}`;
}

export const everyStrings = {
  name: 'Inkpanel',
  clock,
  frameName: (name: string, seconds: number) => `${name}, ${clock(seconds)}`,
};
