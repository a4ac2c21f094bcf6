// @ts-check
/** photon, Rust in wasm. It changes an RGBA image in place, so each run gets a fresh copy, untimed. */

const FOLDER = '/modules/@silvia-odwyer/photon';

/** The package imports its module as bundlers do; here the import is replaced by a setter. */
async function instantiate() {
  const source = await (await fetch(`${FOLDER}/photon_rs_bg.js`)).text();
  const open = source.replace(/^import \* as wasm from .*$/m, 'let wasm; export const setWasm = (w) => { wasm = w; };');
  const address = URL.createObjectURL(new Blob([open], { type: 'text/javascript' }));
  const photon = await import(address);
  const imports = { './photon_rs_bg.js': photon };
  const { instance } = await WebAssembly.instantiateStreaming(fetch(`${FOLDER}/photon_rs_bg.wasm`), imports);
  photon.setWasm(instance.exports);
  return photon;
}

/** @type {import('../contest.js').Load} */
export async function load({ width, height, data }) {
  const photon = await instantiate();
  const bytes = new Uint8Array(data);
  /** @type {any} */
  let image;
  const prepare = () => {
    image?.free();
    image = new photon.PhotonImage(bytes, width, height);
    return image;
  };
  const on = (/** @type {(image: any) => void} */ run) => ({ prepare, run });

  return ({ id, luma, params: p }) => {
    // It has no luma images either: its colour operations are compared with colour only.
    if (luma) return undefined;
    switch (id.split(' ')[0]) {
      case 'to_gray':
        return on((i) => photon.grayscale_human_corrected(i));
      case 'brightness':
        return on((i) => photon.inc_brightness(i, 40));
      case 'saturation':
        return on((i) => photon.saturate_hsl(i, 0.2));
      case 'hue':
        return on((i) => photon.hue_rotate_hsl(i, p.angle));
      case 'gaussian':
        return on((i) => photon.gaussian_blur(i, Math.round(p.sigma)));
      case 'size': {
        const [w, h] = [(width * p.percent) / 100, (height * p.percent) / 100];
        return on((i) => photon.resize(i, w, h, photon.SamplingFilter.CatmullRom).free());
      }
      default:
        return undefined;
    }
  };
}
