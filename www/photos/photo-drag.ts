/** Data type of a dragged photo. */
export const PHOTO = 'text/x-inkpanel-photo';
