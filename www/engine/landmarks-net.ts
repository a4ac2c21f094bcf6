/** Address of the landmark model, if the site contains it. Missing files are never requested. */

const FOUND = Object.values(
  import.meta.glob('../models/landmarks.onnx', { query: '?url', import: 'default', eager: true }),
) as string[];

export const NET: string | undefined = FOUND[0];
