export const keyStrings = {
  letterKeys: 'Raccourcis d’une lettre',
  // As the keyboard calls them; what is called alike everywhere is not here.
  keyNames: {
    Ctrl: 'Ctrl',
    Space: 'Espace',
    Shift: 'Maj',
    Enter: 'Entrée',
    PageUp: 'Page préc.',
    PageDown: 'Page suiv.',
  },
  // What the list says of keys that are no action with a name of its own.
  keyAbout: {
    walk: 'Passer d’une case à l’autre',
    turn: 'Aller d’une page à l’autre',
    frame: 'Déplacer la photo d’une case avec les flèches',
    scrub: 'Image précédente ou suivante d’une vidéo ; avec Maj, une seconde',
    zoom: 'Agrandir ou réduire la photo d’une case, la réinitialiser',
    choose: 'Sélectionner une case',
    slant: 'Incliner une séparation du gabarit',
    list: 'Cette liste',
  },
};
