/** Images in a document, as data URLs. */

import { useEffect, useState } from 'preact/hooks';

/** @returns the data URL of a file with these bytes */
export function urlOf(bytes: Uint8Array, type: string): string {
  return `data:${type};base64,${btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''))}`;
}

/** the image of a data URL, as a file, because the policy blocks images with data URLs */
export function pictureOf(url: string): Blob {
  const [head, letters = ''] = url.split(',');
  const type = /^data:(image\/\w+);/.exec(head)?.[1];
  return new Blob([Uint8Array.from(atob(letters), (letter) => letter.charCodeAt(0))], { type });
}

export function DataPicture({ url, alt, class: own }: { url: string; alt: string; class: string }) {
  const [source, setSource] = useState('');
  useEffect(() => {
    const address = URL.createObjectURL(pictureOf(url));
    setSource(address);
    return () => URL.revokeObjectURL(address);
  }, [url]);
  return source === '' ? null : <img class={own} src={source} alt={alt} />;
}
