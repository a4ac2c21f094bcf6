/** a globally unique id of random bits (`randomUUID` is missing on plain http) */
export function freshId(bytes: number = 16): string {
  return Array.from(crypto.getRandomValues(new Uint8Array(bytes)), (byte) => byte.toString(16).padStart(2, '0')).join(
    '',
  );
}
