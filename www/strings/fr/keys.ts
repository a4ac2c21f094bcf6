export const keyStrings = {
  letterKeys: 'Raccourcis d’une lettre',
  // Labels of the keys. Keys with the same label in every language are missing.
  keyNames: {
    Ctrl: 'Ctrl',
    Space: 'Espace',
    Shift: 'Maj',
    Enter: 'Entrée',
    PageUp: 'Page préc.',
    PageDown: 'Page suiv.',
  },
  // Descriptions of keys that belong to no named action.
  keyAbout: {
    walk: 'Passer d’une case à l’autre',
    turn: 'Aller d’une page à l’autre',
    frame: 'Déplacer la photo d’une case avec les flèches',
    scrub: 'Image précédente ou suivante d’une vidéo ; avec Maj, une seconde',
    zoom: 'Agrandir ou réduire la photo d’une case, la réinitialiser',
    choose: 'Sélectionner une case',
    slant: 'Incliner une séparation du gabarit',
    sizeInset: 'Changer la taille d’une incrustation',
    originals: 'Maintenir pour voir les photos d’origine',
    list: 'Cette liste',
  },
};
