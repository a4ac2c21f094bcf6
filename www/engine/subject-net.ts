/** Where the net that finds what a photo shows is, if it is part of the site: nobody asks for a file that is not there. */

const FOUND = Object.values(
  import.meta.glob('../models/subject.onnx', { query: '?url', import: 'default', eager: true }),
) as string[];

export const NET: string | undefined = FOUND[0];
