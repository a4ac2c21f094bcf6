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
  help: 'Ayuda y atajos de teclado',
  helpShort: 'Ayuda',
  searchHelp: 'Buscar en la ayuda',
  helpTopics: 'Temas',
  helpFound: (topics: number, keys: number) =>
    `Resultados: ${topics === 1 ? '1 tema' : `${topics} temas`}, ${keys === 1 ? '1 atajo' : `${keys} atajos`}`,
  helpNone: (text: string) => `Aquí no hay nada sobre «${text}». Prueba con otra palabra o mira todos los temas.`,
  allTopics: 'Ver todos los temas',
  hintsAgain: 'Mostrar los consejos otra vez',
  hint: {
    shuffle: 'Baraja hasta que te guste. Puedes recuperar cualquier página que hayas visto.',
    crop: 'Arrastra para mover la imagen y gira la rueda para acercarla.',
    cropTouch: 'Arrastra para mover la imagen y pellizca para acercarla.',
    lock: 'Fija lo que te guste. Barajar cambia solo lo demás.',
  },
  topics: {
    adding: {
      title: 'Añadir fotos y vídeos',
      text: `Suelta fotos o vídeos en cualquier parte de la ventana, pégalos o pulsa «${photos.addPhotos}». Para echar un vistazo primero, usa «${startStrings.trySamples}». Puedes añadir más en cualquier momento.`,
    },
    films: {
      title: 'Fotogramas de un vídeo',
      text: `Inkpanel extrae fotogramas de un vídeo, que son fotos como las demás. Pulsa su nombre en la lista de fotos para decir dónde empieza y acaba y cuántos fotogramas quieres; «${photos.takeFrames}» los toma. Una viñeta con un fotograma puede pasar a otro anterior o posterior. «${sounds.hear}», en «${side.sideTab.words}», propone onomatopeyas para lo que se oye cerca de los fotogramas de tus páginas.`,
    },
    shuffle: {
      title: 'Barajar',
      text: `«${board.shuffle}» hace una página nueva con tus fotos, con otra plantilla y otro estilo. Al lado, «${board.part.layout}», «${board.part.style}» y «${board.part.photos}» cambian solo esa parte. En un teléfono también puedes deslizar la página hacia un lado.`,
    },
    locks: {
      title: 'Fijar lo que debe quedarse',
      text: `El candado junto a «${board.part.layout}», «${board.part.style}» o «${board.part.photos}» conserva esa parte mientras barajas lo demás. «${panels.lockPanel}» conserva la foto de una viñeta con su encuadre. Una foto con estrella se muestra grande, aquí y cada vez que barajas.`,
    },
    versions: {
      title: 'Volver atrás y páginas favoritas',
      text: `«${board.undo}» y «${board.redo}» recorren todo lo que has hecho. «${board.previous}» y «${board.next}» recorren las páginas que has visto, y el número entre ellas las muestra todas. El corazón marca una página como favorita.`,
    },
    ideas: {
      title: 'Sugerencias',
      text: `La tira bajo la página, «${side.moreIdeas}», muestra otras páginas con las mismas fotos. Un clic toma una de ellas. Señala una para verla grande.`,
    },
    layouts: {
      title: 'Plantillas',
      text: `Elige una plantilla por su familia y su número de viñetas; «${side.surprise}» inventa una. Con «${side.editLayout}» arrastras e inclinas las divisiones entre las viñetas, mueves recuadros y divides o quitas viñetas. «${side.saveLayout}» la guarda como archivo y la pone en «${side.myLayouts}».`,
    },
    joining: {
      title: 'Fundir viñetas, y una foto en varias viñetas',
      text: `Activa «${panels.selectPanels}» y elige viñetas que se toquen. «${panels.joinPanels}» hace de ellas una sola, si juntas tienen la forma de una. «${panels.merge}» deja las viñetas y hace pasar una imagen por todas; «${panels.split}» las separa otra vez.`,
    },
    crop: {
      title: 'Mover y acercar una imagen',
      text: `Arrastra la imagen dentro de su viñeta para moverla, y gira la rueda o pellizca para acercarla. Con el dedo, toca antes la viñeta. Un doble clic ajusta la imagen a su motivo. «${panels.resetCrop}» restablece el encuadre automático. «${panels.rotatePhoto}» endereza una foto tumbada y «${panels.flipPhoto}» la refleja; la foto cambia en todas las páginas.`,
    },
    exchange: {
      title: 'Intercambiar fotos',
      text: `Arrastra una imagen fuera de su viñeta hasta otra, y las dos cambian de sitio; «${panels.swapPhoto}» hace lo mismo con clics. Pulsa una foto de la lista y luego una viñeta, y la foto va allí. Desmarca una foto de la lista para dejarla fuera.`,
    },
    subject: {
      title: 'Corregir cuál es el motivo',
      text: `«${panels.breakFrame}», los estilos solo para el motivo o el fondo y el texto que no tapa cuerpos siguen lo que se detectó en la foto. Si no es correcto, lo abre «${brush.correct}», entre las herramientas de una viñeta, o el pincel de una foto de la lista que hayas pulsado: pinta lo que pertenece al motivo, quita lo que no, o elige otro motivo. «${brush.found}» vuelve a lo detectado.`,
    },
    styles: {
      title: 'Estilos',
      text: `Cada estilo se muestra en una foto tuya. Búscalos por su nombre o elige un tipo; tus favoritos y los últimos usados van primero. «${designer.styleShuffle}» dice de dónde saca los estilos «${board.shuffle}».`,
    },
    designer: {
      title: 'Hacer un estilo: el diseñador',
      text: `Un estilo tiene dos capas, una para los colores y otra para las líneas, y cada una es una fila de bloques. «${designer.addBlock}» añade uno, sus controles lo cambian y «${designer.compare}» muestra lo que se ha hecho. Arrastra un bloque a su sitio o insértalo con el signo más entre dos tarjetas. «${designer.saveStyle}» lo pone en «${designer.myStyles}».`,
    },
    explorer: {
      title: 'Encontrar un estilo: el explorador',
      text: `Se abre con estilos inventados en tu propia foto, y «${designer.generate}» hace más. Un clic muestra uno en grande. Guarda los que te gusten con el corazón, haz más a partir de dos con «${designer.breed}» y pon uno en la página con «${designer.useStyle}». Todos se pueden cambiar en el diseñador.`,
    },
    imitation: {
      title: 'Un estilo de una imagen',
      text: `«${imitation.styleFromPicture}» lleva a tus fotos el aspecto de una página de cómic, un grabado o una pintura. Elige allí la imagen o suéltala en cualquier lugar con Alt pulsada. En pocos segundos ves de tres a seis estilos en tu propia foto; usa uno, guárdalo o cámbialo en el diseñador.`,
    },
    words: {
      title: 'Cartelas, bocadillos y onomatopeyas',
      text: `En «${side.sideTab.words}» añades una cartela, un bocadillo o una onomatopeya; se pone donde no tape ninguna cara, si hay sitio. Arrástrala, o escribe en ella con un doble clic; con el dedo, tócala otra vez. Los vídeos también traen texto: «${words.addSubtitles}» lee un archivo de subtítulos.`,
    },
    alike: {
      title: 'Fotos parecidas y excluidas',
      text: `De las fotos que se parecen se usa la más nítida y las demás se excluyen, igual que las desenfocadas. Están en «${photos.setAside}»: marca una para usarla. Cuánto deben parecerse lo dices en «${photos.choice}».`,
    },
    pages: {
      title: 'Varias páginas',
      text: `«${book.add}» añade una página a la historia, hecha con fotos que aún no muestra ninguna página mientras queden. «${book.spreadAlbum}» pone todas las fotos en tantas páginas como hagan falta. Las páginas se pueden mover, quitar y poner en un mismo estilo.`,
    },
    paper: {
      title: 'Formato de página y márgenes',
      text: `Los ajustes de la página tienen su formato, desde A4 hasta medidas propias, el margen, la calle entre las viñetas, los bordes, las esquinas redondas y los colores. Son los mismos para todas las páginas de una historia.`,
    },
    saving: {
      title: 'Guardar',
      text: `Tu trabajo se guarda solo en este navegador, en este dispositivo, y sigue ahí cuando vuelves. En «${storage.projects}» está todo, cada cosa con su nombre. Si borras los datos de este navegador desaparece, así que guarda también como archivo lo que aprecies.`,
    },
    files: {
      title: 'Archivos de proyecto',
      text: `En «${storage.projects}», «${storage.saveProject}» hace un solo archivo de todo, con tus fotos a tamaño completo. Suéltalo en la ventana, aquí o en otro dispositivo, para continuar. Un PNG de una página con datos del proyecto se abre igual; encuentra sus fotos en este dispositivo o las lleva dentro, si elegiste «${pngStrings.cargoKind.photos}».`,
    },
    export: {
      title: 'Exportar: PNG, JPEG, WebP, PDF',
      text: `«${board.download}» guarda la página a tamaño de impresión, a partir de tus fotos originales. «${board.export}» tiene JPEG, WebP y PDF, además de la calidad. Varias páginas se convierten en un PDF, un ZIP o un CBZ para lectores de cómics.`,
    },
    comics: {
      title: 'Cómics para leer: HTML, EPUB, CBZ',
      text: `«${board.export}» también hace cómics. «Cómic en HTML» es un archivo que cualquiera puede abrir en un navegador: toca, desliza o usa las flechas para ir de viñeta en viñeta, mira páginas enteras o léelo todo como texto. EPUB es para aplicaciones de lectura y CBZ para lectores de cómics. En todos se conoce el orden de las viñetas, con sus palabras y, si se encontró, lo que muestran; así se pueden leer en voz alta.`,
    },
    privacy: {
      title: 'Sin conexión y en privado',
      text: `Tus fotos nunca salen de este dispositivo: todo el trabajo se hace en este navegador y no se envía nada a ningún sitio. Las caras se localizan para que las viñetas no las corten; no se reconoce a nadie. La ubicación de una foto solo se lee para nombrar su lugar en los textos, con una tabla de GeoNames (CC BY 4.0); las páginas exportadas nunca la contienen. Después de la primera visita, Inkpanel también funciona sin conexión. Si el navegador puede, «${offlineStrings.install}» le da una ventana propia.`,
    },
    keyboard: {
      title: 'Con el teclado',
      text: `Todo se puede hacer sin ratón; los atajos están más abajo. Las flechas pasan de una viñeta a otra, Intro toma la imagen de una y entonces las flechas la mueven. Las letras sueltas se pueden desactivar como atajos, para quienes hablan a su ordenador.`,
    },
  },
};
