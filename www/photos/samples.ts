/** The sample album, fetched from the site. */

import { strings } from '../strings/strings.ts';

type Sample = { file: string; title: string; author: string; licence: string };

/** @returns the photos, and their authors by file name */
export async function fetchSamples(): Promise<{ files: File[]; credits: Map<string, string> }> {
  const base = new URL('./samples/', document.baseURI);
  const index: Sample[] = await (await fetchOk(new URL('index.json', base))).json();
  const files = index.map(async ({ file }) => new File([await (await fetchOk(new URL(file, base))).blob()], file));
  return {
    files: await Promise.all(files),
    credits: new Map(index.map((sample) => [sample.file, strings.credit(sample)])),
  };
}

async function fetchOk(address: URL) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address.pathname}: ${response.status}`);
  return response;
}
