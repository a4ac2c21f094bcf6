export const startStrings = {
  lead: ['Déposez vos photos.', 'Faites-en une BD.'],
  leadMore: 'Inkpanel les choisit, les cadre, les encre et les met en page. Mélangez jusqu’à l’adorer.',
  chooseFiles: 'Choisir des photos ou une vidéo',
  filesLabel: 'Photos ou vidéo',
  trySamples: 'Essayer l’album d’exemple',
  startPages: 'Trois planches faites avec l’album d’exemple',
  recentProjects: 'Projets récents',
  privacy: 'Rien ne quitte cet appareil.',
  dropHere: 'Relâchez pour ajouter vos photos',
  framed: 'Inkpanel ne fonctionne pas dans d’autres sites, pour vous protéger du détournement de clic.',
  openInTab: 'Ouvrir Inkpanel dans un nouvel onglet',
  starting: 'Démarrage d’Inkpanel',
};
