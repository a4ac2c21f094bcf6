/** Types of the used parts of gifenc 1.0.3, which has no type definitions. */
declare module 'gifenc' {
  type Palette = number[][];
  type Format = 'rgb565' | 'rgb444' | 'rgba4444';

  /** @param rgba pixels */
  export function quantize(rgba: Uint8ClampedArray, most: number, options?: { format?: Format }): Palette;
  /** @returns for each pixel its place in the palette */
  export function applyPalette(rgba: Uint8ClampedArray, palette: Palette, format?: Format): Uint8Array;
  export function GIFEncoder(): {
    /** @param options `delay` in milliseconds, rounded to hundredths of a second; `repeat` 0 means forever */
    writeFrame(
      index: Uint8Array,
      width: number,
      height: number,
      options: { palette: Palette; delay: number; repeat?: number },
    ): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  };
}
