export const startStrings = {
  lead: ['Déposez vos photos.', 'Faites-en une BD.'],
  leadMore: 'Inkpanel les choisit, les cadre, les encre et les met en page. Mélangez jusqu’à l’adorer.',
  chooseFiles: 'Choisir des photos ou une vidéo',
  filesLabel: 'Photos ou vidéo',
  trySamples: 'Essayer l’album d’exemple',
  privacy: 'Rien ne quitte cet appareil.',
  dropHere: 'Relâchez pour ajouter vos photos',
  framed:
    'Un autre site montre Inkpanel dans sa propre page. Il n’y fonctionne pas, pour que personne ne vous fasse appuyer sur ce que vous ne voyez pas.',
  openInTab: 'Ouvrir Inkpanel dans son propre onglet',
  starting: 'Préparation de l’encre',
};
