export const startStrings = {
  lead: ['Solte suas fotos.', 'Ganhe uma página de HQ.'],
  leadMore: 'O Inkpanel escolhe, enquadra, passa o nanquim e monta. Embaralhe até amar.',
  chooseFiles: 'Escolher fotos ou um vídeo',
  filesLabel: 'Fotos ou vídeo',
  trySamples: 'Testar o álbum de exemplo',
  startPages: 'Três páginas de quadrinhos feitas com o álbum de exemplo',
  recentProjects: 'Projetos recentes',
  privacy: 'Nada sai deste aparelho.',
  dropHere: 'Solte para adicionar suas fotos',
  framed: 'O Inkpanel não funciona dentro de outros sites, para proteger você de clickjacking.',
  openInTab: 'Abrir o Inkpanel em uma nova aba',
  starting: 'Iniciando o Inkpanel',
};
