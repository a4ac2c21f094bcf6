// @ts-check
/** OpenCV.js as npm has it: the same operations, on matrices in its own memory. */

import * as tables from './tables.js';

/** @type {import('../contest.js').Load} */
export async function load({ width, height, data }) {
  // The package is a script that leaves a promise of its module in the global `cv`.
  await import('/modules/@techstark/opencv-js/dist/opencv.js');
  const cv = await /** @type {any} */ (globalThis).cv;
  const rgba = cv.matFromArray(height, width, cv.CV_8UC4, data);
  const [rgb, gray, out, a, b] = Array.from({ length: 5 }, () => new cv.Mat());
  cv.cvtColor(rgba, rgb, cv.COLOR_RGBA2RGB);
  cv.cvtColor(rgba, gray, cv.COLOR_RGBA2GRAY);
  const auto = new cv.Size(0, 0);

  /** @param {ArrayLike<number>} table */
  const lut = (table) => cv.matFromArray(1, 256, cv.CV_8UC1, table);
  /** @param {number[]} m rows of a 3x3 matrix */
  const mix = (m) => {
    const matrix = cv.matFromArray(3, 3, cv.CV_32F, m);
    return () => cv.transform(rgb, out, matrix);
  };
  /** @param {any} source @param {any} target @param {number} sigma @param {number} p */
  const xdog = (source, target, sigma, p) => {
    cv.GaussianBlur(source, a, auto, sigma);
    cv.GaussianBlur(source, b, auto, 1.6 * sigma);
    cv.addWeighted(a, 1 + p, b, -p, 0, target);
  };
  const planes = new cv.MatVector();
  planes.push_back(gray);
  const mask = new cv.Mat();
  const histogram = new cv.Mat();
  const stretch = (/** @type {number} */ low, /** @type {number} */ high) => {
    cv.calcHist(planes, [0], mask, histogram, [256], [0, 256]);
    const [from, to] = tables.percentiles(histogram.data32F, low, high);
    gray.convertTo(out, -1, 255 / (to - from), (-255 * from) / (to - from));
  };

  return ({ id, luma, params: p }) => {
    const source = luma ? gray : rgb;
    switch (id.split(' ')[0]) {
      case 'to_gray':
        return () => cv.cvtColor(rgba, out, cv.COLOR_RGBA2GRAY);
      case 'to_color':
        return () => {
          cv.cvtColor(rgb, a, cv.COLOR_RGB2YUV);
          cv.cvtColor(a, out, cv.COLOR_YUV2RGB);
        };
      case 'posterize':
      case 'luma_posterize': {
        const table = lut(tables.posterize(p.levels));
        return () => cv.LUT(source, table, out);
      }
      case 'soft_threshold': {
        const table = lut(tables.softThreshold(p.phi, p.epsilon));
        return () => cv.LUT(gray, table, out);
      }
      case 'brightness':
        return () => source.convertTo(out, -1, p.gain, 0);
      case 'saturation':
        return mix(tables.saturation(p.amount));
      case 'hue':
        return mix(tables.hue(p.angle));
      case 'gaussian':
        return () => cv.GaussianBlur(source, out, auto, p.sigma, 0, cv.BORDER_REPLICATE);
      case 'sobel':
        return () => {
          cv.Sobel(gray, a, cv.CV_32F, 1, 0);
          cv.Sobel(gray, b, cv.CV_32F, 0, 1);
          cv.magnitude(a, b, a);
          a.convertTo(out, cv.CV_8U, p.gain / 4, 0);
        };
      case 'xdog':
        return () => xdog(gray, out, p.sigma, p.p);
      case 'size': {
        const size = new cv.Size((width * p.percent) / 100, (height * p.percent) / 100);
        return () => cv.resize(source, out, size, 0, 0, p.percent < 100 ? cv.INTER_AREA : cv.INTER_CUBIC);
      }
      case 'detail':
        // The usual diameter of 9 instead of 25 for this sigma_s: less work, an advantage for OpenCV.
        return () => {
          cv.bilateralFilter(gray, a, 9, p.sigma_r, p.sigma_s, cv.BORDER_REPLICATE);
          cv.addWeighted(gray, 1 + p.delta / 100, a, -p.delta / 100, 0, out);
        };
      case 'equalize':
        return () => stretch(p.low, p.high);
      case 'comic': {
        const table = lut(tables.posterize(8));
        const ink = new cv.Mat();
        const edge = lut(tables.softThreshold(0.03, 80));
        const c = new cv.Mat();
        return () => {
          cv.bilateralFilter(rgb, c, 9, 25, 8);
          cv.LUT(c, table, c);
          cv.cvtColor(rgb, ink, cv.COLOR_RGB2GRAY);
          xdog(ink, ink, 1.5, 20);
          cv.LUT(ink, edge, ink);
          cv.cvtColor(ink, ink, cv.COLOR_GRAY2RGB);
          cv.multiply(c, ink, out, 1 / 255);
        };
      }
      default:
        return undefined;
    }
  };
}
