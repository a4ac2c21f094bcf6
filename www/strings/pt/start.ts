export const startStrings = {
  lead: ['Solte suas fotos.', 'Ganhe uma página de HQ.'],
  leadMore: 'O Inkpanel escolhe, enquadra, passa o nanquim e monta. Embaralhe até amar.',
  chooseFiles: 'Escolher fotos ou um vídeo',
  filesLabel: 'Fotos ou vídeo',
  trySamples: 'Testar o álbum de exemplo',
  privacy: 'Nada sai deste aparelho.',
  dropHere: 'Solte para adicionar suas fotos',
  framed:
    'Outro site mostra o Inkpanel dentro da própria página. Lá ele não funciona, para que ninguém faça você apertar o que não vê.',
  openInTab: 'Abrir o Inkpanel em uma aba própria',
  starting: 'Preparando o nanquim',
};
