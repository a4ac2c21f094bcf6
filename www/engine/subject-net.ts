/** Address of the subject model, if the site contains it. Missing files are never requested. */

const FOUND = Object.values(
  import.meta.glob('../models/subject.onnx', { query: '?url', import: 'default', eager: true }),
) as string[];

export const NET: string | undefined = FOUND[0];
