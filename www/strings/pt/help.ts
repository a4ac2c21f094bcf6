import { boardStrings as board } from './board.ts';
import { bookStrings } from './book.ts';
import { brushStrings } from './brush.ts';
import { designerStrings as designer } from './designer.ts';
import { imitationStrings as imitation } from './imitation.ts';
import { storageStrings as storage } from './storage.ts';
import { offlineStrings } from './offline.ts';
import { panelStrings as panels } from './panels.ts';
import { photoStrings as photos } from './photos.ts';
import { soundStrings } from './sounds.ts';
import { pngStrings } from './png.ts';
import { sideStrings as side } from './side.ts';
import { startStrings } from './start.ts';
import { wordStrings as words } from './words.ts';

const { filmSounds: sounds } = soundStrings;

const { book } = bookStrings;

const { brush } = brushStrings;

export const helpStrings = {
  help: 'Ajuda e atalhos de teclado',
  helpShort: 'Ajuda',
  searchHelp: 'Buscar na ajuda',
  helpTopics: 'Assuntos',
  helpFound: (topics: number, keys: number) =>
    `Resultados: ${topics < 2 ? `${topics} assunto` : `${topics} assuntos`}, ${keys < 2 ? `${keys} atalho` : `${keys} atalhos`}`,
  helpNone: (text: string) => `Não há nada aqui sobre “${text}”. Tente outra palavra ou veja todos os assuntos.`,
  allTopics: 'Mostrar todos os assuntos',
  hintsAgain: 'Mostrar as dicas de novo',
  hint: {
    shuffle: 'Embaralhe até gostar. Qualquer página que você já viu pode voltar.',
    crop: 'Arraste para mover a imagem e gire a roda do mouse para ampliar.',
    cropTouch: 'Arraste para mover a imagem e use dois dedos para ampliar.',
    lock: 'Trave o que você gostar. Embaralhar muda só o resto.',
  },
  topics: {
    adding: {
      title: 'Adicionar fotos e vídeos',
      text: `Solte fotos ou vídeos em qualquer lugar da janela, cole-os ou aperte “${photos.addPhotos}”. Para dar uma olhada antes, use “${startStrings.trySamples}”. Você pode adicionar mais a qualquer momento.`,
    },
    films: {
      title: 'Imagens de um vídeo',
      text: `De um vídeo, o Inkpanel tira algumas imagens, que passam a ser fotos como as outras. Aperte o nome dele na lista de fotos para dizer onde começa e termina e quantas imagens você quer; “${photos.takeFrames}” as tira. Um quadro que mostra uma imagem do vídeo pode ir para uma anterior ou seguinte. “${sounds.hear}”, em “${side.sideTab.words}”, propõe onomatopeias para o que se ouve perto das imagens das suas páginas.`,
    },
    shuffle: {
      title: 'Embaralhar',
      text: `“${board.shuffle}” faz uma página nova com suas fotos, com outro layout e outro estilo. Ao lado, “${board.part.layout}”, “${board.part.style}” e “${board.part.photos}” mudam só essa parte. No celular, você também pode deslizar a página para o lado.`,
    },
    locks: {
      title: 'Travar o que deve ficar',
      text: `O cadeado ao lado de “${board.part.layout}”, “${board.part.style}” ou “${board.part.photos}” mantém essa parte enquanto você embaralha o resto. “${panels.lockPanel}” mantém a foto de um quadro, como está enquadrada. Uma foto com estrela aparece grande, aqui e sempre que você embaralha.`,
    },
    versions: {
      title: 'Voltar atrás e páginas favoritas',
      text: `“${board.undo}” e “${board.redo}” percorrem tudo o que você fez. “${board.previous}” e “${board.next}” percorrem as páginas que você viu, e o número entre elas mostra todas. O coração marca uma página como favorita.`,
    },
    ideas: {
      title: 'Sugestões',
      text: `A tira abaixo da página, “${side.moreIdeas}”, mostra outras páginas com as mesmas fotos. Um clique usa uma delas. Aponte para uma para vê-la grande.`,
    },
    layouts: {
      title: 'Layouts',
      text: `Escolha um layout pela família e pelo número de quadros; “${side.surprise}” inventa um. Com “${side.editLayout}”, você arrasta e inclina as divisórias entre os quadros, move encaixes e divide ou remove quadros. “${side.saveLayout}” o salva em um arquivo e o põe em “${side.myLayouts}”.`,
    },
    joining: {
      title: 'Fundir quadros, e uma foto em vários quadros',
      text: `Ative “${panels.selectPanels}” e escolha quadros que se toquem. “${panels.joinPanels}” faz deles um só, se juntos tiverem a forma de um. “${panels.merge}” mantém os quadros e faz uma imagem passar por todos; “${panels.split}” os separa de novo.`,
    },
    crop: {
      title: 'Mover e ampliar uma imagem',
      text: `Arraste a imagem dentro do quadro para movê-la, e gire a roda do mouse ou use dois dedos para ampliar. Com o dedo, toque antes no quadro. Um clique duplo ajusta a imagem ao assunto. “${panels.resetCrop}” restaura o enquadramento automático. “${panels.rotatePhoto}” endireita uma foto deitada e “${panels.flipPhoto}” a espelha; a foto muda em todas as páginas.`,
    },
    exchange: {
      title: 'Trocar fotos',
      text: `Arraste uma imagem para fora do quadro até outro, e as duas trocam de lugar; “${panels.swapPhoto}” faz o mesmo com cliques. Clique em uma foto da lista e depois em um quadro, e a foto vai para lá. Desmarque uma foto da lista para deixá-la de fora.`,
    },
    subject: {
      title: 'Corrigir qual é o assunto',
      text: `“${panels.breakFrame}”, os estilos só para o assunto ou o fundo e o texto que evita corpos usam o assunto detectado. Se ele está errado, “${brush.correct}”, entre as ferramentas de um quadro, abre a foto, ou o pincel em uma foto da lista em que você clicou: pinte o que pertence ao assunto, retire o que não pertence, ou escolha outro assunto. “${brush.found}” volta ao assunto detectado.`,
    },
    styles: {
      title: 'Estilos',
      text: `Cada estilo aparece em uma foto sua. Busque pelo nome ou escolha um tipo; seus favoritos e os últimos usados vêm primeiro. “${designer.styleShuffle}” diz de onde “${board.shuffle}” tira os estilos.`,
    },
    designer: {
      title: 'Fazer um estilo: o designer',
      text: `Um estilo tem duas camadas, uma para as cores e outra para as linhas, e cada uma é uma fila de blocos. “${designer.addBlock}” adiciona um, os controles dele o mudam e “${designer.compare}” mostra o que foi feito. Arraste um bloco até o lugar dele ou insira-o com o sinal de mais entre dois cartões. “${designer.saveStyle}” o põe em “${designer.myStyles}”.`,
    },
    explorer: {
      title: 'Encontrar um estilo: o explorador',
      text: `Ele se abre com estilos inventados na sua própria foto, e “${designer.generate}” faz mais. Um clique mostra um deles grande. Guarde com o coração os que você gostar, faça outros a partir de dois com “${designer.breed}” e ponha um na página com “${designer.useStyle}”. Todos podem ser mudados no designer.`,
    },
    imitation: {
      title: 'Um estilo de uma imagem',
      text: `“${imitation.styleFromPicture}” leva para suas fotos o visual de uma página de quadrinhos, de uma gravura ou de uma pintura. Escolha a imagem ali ou solte-a em qualquer lugar com Alt pressionada. Em poucos segundos você vê de três a seis estilos na sua própria foto; use um, salve-o ou mude-o no designer.`,
    },
    words: {
      title: 'Caixas de texto, balões e onomatopeias',
      text: `Em “${side.sideTab.words}”, você adiciona uma caixa de texto, um balão ou uma onomatopeia; o texto fica onde não esconde nenhum rosto, se houver espaço. Arraste-o, ou escreva nele com um clique duplo; com o dedo, toque nele mais uma vez. Vídeos também trazem textos: “${words.addSubtitles}” lê um arquivo de legendas.`,
    },
    alike: {
      title: 'Fotos parecidas e excluídas',
      text: `Entre fotos que se parecem, a mais nítida é usada e as outras são excluídas, assim como as desfocadas. Elas estão em “${photos.setAside}”: marque uma para usá-la. Quanto elas precisam se parecer, você diz em “${photos.choice}”.`,
    },
    pages: {
      title: 'Várias páginas',
      text: `“${book.add}” adiciona uma página à história, feita de fotos que nenhuma página mostra ainda, enquanto houver. “${book.spreadAlbum}” põe todas as fotos em quantas páginas forem precisas. As páginas podem ser movidas, removidas e postas no mesmo estilo.`,
    },
    paper: {
      title: 'Formato da página e margens',
      text: `As configurações da página têm o formato, do A4 a medidas próprias, a margem, a sarjeta entre os quadros, as bordas, os cantos redondos e as cores. Elas são as mesmas para todas as páginas de uma história.`,
    },
    saving: {
      title: 'Salvar',
      text: `Seu trabalho é salvo sozinho neste navegador, neste aparelho, e continua aqui quando você volta. Em “${storage.projects}” está tudo, cada um com seu nome. Se você limpar os dados deste navegador, ele se perde; guarde também em um arquivo o que você ama.`,
    },
    files: {
      title: 'Arquivos de projeto',
      text: `Em “${storage.projects}”, “${storage.saveProject}” faz de tudo um só arquivo, com suas fotos em tamanho total. Solte-o na janela, aqui ou em outro aparelho, para continuar. Um PNG de uma página com os dados do projeto abre do mesmo jeito; ele encontra as fotos neste aparelho, ou as traz dentro se você escolheu “${pngStrings.cargoKind.photos}”.`,
    },
    export: {
      title: 'Exportar: PNG, JPEG, WebP, PDF',
      text: `“${board.download}” salva a página em tamanho de impressão, a partir das suas fotos originais. “${board.export}” tem JPEG, WebP e PDF, além da qualidade. Várias páginas viram um PDF, um ZIP ou um CBZ para leitores de quadrinhos.`,
    },
    comics: {
      title: 'Quadrinhos para ler: HTML, EPUB, CBZ',
      text: `“${board.export}” também faz quadrinhos. “Quadrinho em HTML” é um arquivo que qualquer pessoa pode abrir em um navegador: toque, deslize ou use as setas para ir de quadro em quadro, veja páginas inteiras ou leia tudo como texto. EPUB é para aplicativos de leitura, CBZ para leitores de quadrinhos. Em todos eles a ordem dos quadros é conhecida, com as palavras e, se foi encontrado, o que eles mostram; assim podem ser lidos em voz alta.`,
    },
    privacy: {
      title: 'Sem conexão e em particular',
      text: `Suas fotos nunca saem deste aparelho: todo o trabalho é feito neste navegador, e nada é enviado a lugar nenhum. Os rostos são localizados para que os quadros não os cortem; ninguém é reconhecido. A localização de uma foto só é lida para dar nome ao lugar nos textos, com uma tabela do GeoNames (CC BY 4.0); as páginas exportadas nunca a contêm. Depois da primeira visita, o Inkpanel também funciona sem conexão. Onde o navegador permite, “${offlineStrings.install}” dá a ele uma janela própria.`,
    },
    keyboard: {
      title: 'Pelo teclado',
      text: `Tudo pode ser feito sem mouse; os atalhos estão abaixo. As setas vão de um quadro a outro, Enter pega a imagem de um deles, e então as setas a movem. As letras sozinhas podem ser desligadas como atalhos, para quem fala com o computador.`,
    },
  },
};
