// @ts-check

/**
 * @param {number} [bytes]
 * @returns {string} an id that nothing else has, anywhere: random bits (`randomUUID` is missing on plain http)
 */
export function freshId(bytes = 16) {
  return Array.from(crypto.getRandomValues(new Uint8Array(bytes)), (byte) => byte.toString(16).padStart(2, '0')).join('');
}
