// @ts-check

/** @returns {string} an id that nothing else has, anywhere: 128 random bits (`randomUUID` is missing on plain http) */
export function freshId() {
  return Array.from(crypto.getRandomValues(new Uint8Array(16)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
