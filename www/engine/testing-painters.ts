/** Small models of painters as ONNX files: one convolution of 3 x 3 pixels, and an effect per painter. */

const VARINT = 0;
const BYTES = 2;

function varint(value: number): number[] {
  const out = [];
  let rest = value;
  for (; rest >= 0x80; rest = Math.floor(rest / 0x80)) out.push((rest % 0x80) | 0x80);
  return [...out, rest];
}

const number = (field: number, value: number) => [...varint(field * 8 + VARINT), ...varint(value)];

function bytes(field: number, value: string | readonly number[] | Uint8Array): number[] {
  const all = typeof value === 'string' ? new TextEncoder().encode(value) : value;
  return [...varint(field * 8 + BYTES), ...varint(all.length), ...all];
}

function tensor(name: string, dims: readonly number[], values: Float32Array | BigInt64Array): number[] {
  const raw = new Uint8Array(values.buffer);
  const kind = values instanceof Float32Array ? 1 : 7;
  return [...dims.flatMap((dim) => number(1, dim)), ...number(2, kind), ...bytes(8, name), ...bytes(9, raw)];
}

/** @param attributes texts */
function node(kind: string, inputs: readonly string[], output: string, attributes: Record<string, string> = {}) {
  const list = Object.entries(attributes).map(([name, text]) => [
    ...bytes(1, name),
    ...bytes(4, text),
    ...number(20, 3),
  ]);
  return [
    ...inputs.flatMap((input) => bytes(1, input)),
    ...bytes(2, output),
    ...bytes(4, kind),
    ...list.flatMap((attribute) => bytes(5, attribute)),
  ];
}

/**
 * @param options `painters`: number of them; `last`: the operator at the end; `channels` of the convolution; a picture
 *   has 3
 */
export function smallModel({ painters = 2, last = 'Sigmoid', channels = 3 } = {}): Uint8Array<ArrayBuffer> {
  // Red, green and blue change places, and contours are enhanced.
  const weights = Float32Array.from({ length: channels * 3 * 9 }, (_, i) => {
    const [output, input, place] = [Math.floor(i / 27), Math.floor(i / 9) % 3, i % 9];
    if ((output + 1) % 3 !== input) return 0;
    return place === 4 ? 3 : -0.25;
  });
  const rows = (of: (painter: number, channel: number) => number) =>
    Float32Array.from({ length: painters * channels }, (_, i) => of(Math.floor(i / channels), i % channels));
  const scales = rows((painter) => 1 + painter);
  const offsets = rows((painter, channel) => (channel === painter % 3 ? 1 : -0.5));
  const pads = BigInt64Array.from([0, 0, 1, 1, 0, 0, 1, 1], BigInt);
  const graph = [
    ...[
      node('Pad', ['image', 'pads'], 'padded', { mode: 'reflect' }),
      node('Conv', ['padded', 'weights'], 'sums'),
      node('MatMul', ['painters', 'scales'], 'scale'),
      node('MatMul', ['painters', 'offsets'], 'offset'),
      node('InstanceNormalization', ['sums', 'scale', 'offset'], 'norm'),
      node(last, ['norm'], 'painting'),
    ].flatMap((one) => bytes(1, one)),
    ...bytes(2, 'small'),
    ...[
      tensor('pads', [8], pads),
      tensor('weights', [channels, 3, 3, 3], weights),
      tensor('scales', [painters, channels], scales),
      tensor('offsets', [painters, channels], offsets),
    ].flatMap((one) => bytes(5, one)),
    ...['image', 'painters'].flatMap((name) => bytes(11, bytes(1, name))),
    ...bytes(12, bytes(1, 'painting')),
  ];
  return Uint8Array.from([...number(1, 8), ...bytes(7, graph), ...bytes(8, [...bytes(1, ''), ...number(2, 17)])]);
}
