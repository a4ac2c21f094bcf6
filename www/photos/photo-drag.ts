/** What a photo of the tray is dragged as. */
export const PHOTO = 'text/x-inkpanel-photo';
