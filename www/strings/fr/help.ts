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
  help: 'Aide et raccourcis clavier',
  helpShort: 'Aide',
  searchHelp: 'Chercher dans l’aide',
  helpTopics: 'Sujets',
  helpFound: (topics: number, keys: number) =>
    `Résultats : ${topics < 2 ? `${topics} sujet` : `${topics} sujets`}, ${keys < 2 ? `${keys} raccourci` : `${keys} raccourcis`}`,
  helpNone: (text: string) => `Rien ici sur « ${text} ». Essayez un autre mot, ou parcourez tous les sujets.`,
  allTopics: 'Montrer tous les sujets',
  hintsAgain: 'Montrer à nouveau les conseils',
  hint: {
    shuffle: 'Mélangez jusqu’à ce que la page vous plaise. Chaque page déjà vue peut revenir.',
    crop: 'Faites glisser l’image pour la déplacer, tournez la molette pour zoomer.',
    cropTouch: 'Faites glisser l’image pour la déplacer, pincez pour zoomer.',
    lock: 'Verrouillez ce qui vous plaît. Mélanger ne change que le reste.',
  },
  topics: {
    adding: {
      title: 'Ajouter des photos et des vidéos',
      text: `Déposez des photos ou des vidéos n’importe où sur la fenêtre, collez-les, ou appuyez sur « ${photos.addPhotos} ». Pour jeter d’abord un coup d’œil, prenez « ${startStrings.trySamples} ». Vous pouvez en ajouter à tout moment.`,
    },
    films: {
      title: 'Images d’une vidéo',
      text: `Inkpanel extrait des images d’une vidéo, qui sont alors des photos comme les autres. Appuyez sur son nom dans la liste des photos pour dire où elle commence et finit et combien d’images vous voulez ; « ${photos.takeFrames} » les utilise. Une case qui montre une image de la vidéo peut passer à une image précédente ou suivante. « ${sounds.hear} », dans « ${side.sideTab.words} », propose des onomatopées pour ce que l’on entend près des images de vos pages.`,
    },
    shuffle: {
      title: 'Mélanger',
      text: `« ${board.shuffle} » fait une nouvelle page de vos photos, avec un autre gabarit et un autre style. À côté, « ${board.part.layout} », « ${board.part.style} » et « ${board.part.photos} » ne changent que cette partie. Sur un téléphone, vous pouvez aussi balayer la page sur le côté.`,
    },
    locks: {
      title: 'Verrouiller ce qui doit rester',
      text: `Le cadenas à côté de « ${board.part.layout} », « ${board.part.style} » ou « ${board.part.photos} » garde cette partie pendant que vous mélangez le reste. « ${panels.lockPanel} » garde la photo d’une case, telle qu’elle est cadrée. Une photo marquée d’une étoile est montrée en grand, ici et à chaque mélange.`,
    },
    versions: {
      title: 'Revenir en arrière, et pages favorites',
      text: `« ${board.undo} » et « ${board.redo} » parcourent tout ce que vous avez fait. « ${board.previous} » et « ${board.next} » parcourent les pages que vous avez vues ; le nombre entre les deux les montre toutes. Le cœur marque une page comme favorite.`,
    },
    ideas: {
      title: 'Suggestions',
      text: `La bande sous la page, « ${side.moreIdeas} », montre d’autres pages faites des mêmes photos. Un clic en prend une. Pointez-en une pour la voir en grand.`,
    },
    layouts: {
      title: 'Gabarits',
      text: `Choisissez un gabarit par sa famille et son nombre de cases ; « ${side.surprise} » en invente un. Avec « ${side.editLayout} », vous faites glisser et inclinez les séparations entre les cases, vous déplacez les incrustations, et vous divisez ou retirez des cases. « ${side.saveLayout} » l’enregistre dans un fichier et le met dans « ${side.myLayouts} ».`,
    },
    joining: {
      title: 'Fusionner des cases, et une photo sur plusieurs cases',
      text: `Activez « ${panels.selectPanels} » et choisissez des cases qui se touchent. « ${panels.joinPanels} » en fait une seule, si elles ont ensemble la forme d’une case. « ${panels.merge} » garde les cases et fait passer une image à travers toutes ; « ${panels.split} » les sépare à nouveau.`,
    },
    crop: {
      title: 'Déplacer une image et zoomer',
      text: `Faites glisser l’image dans sa case pour la déplacer ; tournez la molette ou pincez pour zoomer. Au doigt, touchez d’abord la case. Un double clic ajuste l’image à son sujet. « ${panels.resetCrop} » revient à ce que la page choisirait. « ${panels.rotatePhoto} » redresse une photo couchée et « ${panels.flipPhoto} » l’inverse comme dans un miroir ; la photo change sur toutes les pages.`,
    },
    exchange: {
      title: 'Échanger des photos',
      text: `Faites glisser une image hors de sa case sur une autre, et les deux changent de place ; « ${panels.swapPhoto} » fait de même par des clics. Cliquez sur une photo de la liste, puis sur une case, et la photo y va. Décochez une photo de la liste pour l’exclure.`,
    },
    subject: {
      title: 'Corriger ce qu’est le sujet',
      text: `« ${panels.breakFrame} », les styles pour le sujet ou le fond seul et le texte qui évite les corps suivent le sujet détecté dans une photo. Si c’est faux, « ${brush.correct} » parmi les outils d’une case l’ouvre, ou le pinceau sur une photo de la liste que vous avez choisie : peignez ce qui appartient au sujet, enlevez ce qui n’en fait pas partie, ou choisissez un autre sujet. « ${brush.found} » revient au sujet détecté.`,
    },
    styles: {
      title: 'Styles',
      text: `Chaque style est montré sur une de vos photos. Cherchez par le nom, ou choisissez un genre ; vos favoris et les derniers utilisés viennent en premier. « ${designer.styleShuffle} » dit où « ${board.shuffle} » puise les siens.`,
    },
    designer: {
      title: 'Faire un style : l’atelier',
      text: `Un style a deux calques, l’un pour les couleurs et l’autre pour les lignes, et chacun est une suite de blocs. « ${designer.addBlock} » en ajoute un, ses curseurs le changent, et « ${designer.compare} » montre ce qui a été fait. Faites glisser un bloc à sa place, ou insérez-le avec le plus entre deux cartes. « ${designer.saveStyle} » le met dans « ${designer.myStyles} ».`,
    },
    explorer: {
      title: 'Trouver un style : l’explorateur',
      text: `Il s’ouvre sur des styles inventés pour votre propre photo, et « ${designer.generate} » en fait d’autres. Un clic en montre un en grand. Gardez ceux qui vous plaisent avec le cœur, faites-en d’autres à partir de deux avec « ${designer.breed} », et mettez-en un sur la page avec « ${designer.useStyle} ». Tous peuvent être modifiés dans l’atelier.`,
    },
    imitation: {
      title: 'Un style d’après une image',
      text: `« ${imitation.styleFromPicture} » donne à vos photos l’aspect d’une planche de BD, d’une estampe ou d’une peinture. Choisissez l’image à cet endroit, ou déposez-la n’importe où en maintenant Alt. Après quelques secondes, trois à six styles apparaissent sur votre propre photo ; utilisez-en un, enregistrez-le ou modifiez-le dans l’atelier.`,
    },
    words: {
      title: 'Cartouches, bulles et onomatopées',
      text: `Dans « ${side.sideTab.words} », vous ajoutez un cartouche, une bulle ou une onomatopée ; le texte se place là où il ne cache aucun visage, s’il y a de la place. Faites-le glisser, ou écrivez dedans après un double clic ou, au doigt, en le touchant encore une fois. Les vidéos apportent aussi des textes : « ${words.addSubtitles} » lit un fichier de sous-titres.`,
    },
    alike: {
      title: 'Photos semblables et photos exclues',
      text: `Parmi les photos qui se ressemblent, la plus nette est utilisée et les autres sont exclues, comme les photos floues. Elles sont sous « ${photos.setAside} » : cochez-en une pour l’utiliser. À quel point elles doivent se ressembler, vous le dites sous « ${photos.choice} ».`,
    },
    pages: {
      title: 'Plusieurs pages',
      text: `« ${book.add} » ajoute une page à l’histoire, faite de photos qu’aucune page ne montre encore, tant qu’il en reste. « ${book.spreadAlbum} » met toutes les photos sur autant de pages qu’il en faut. Les pages peuvent être déplacées, retirées et mises dans un même style.`,
    },
    paper: {
      title: 'Format de page et marges',
      text: `Les réglages de la page ont son format, de A4 à vos propres mesures, la marge, la gouttière entre les cases, les contours, les coins arrondis et les couleurs. Ils sont les mêmes pour toutes les pages d’une histoire.`,
    },
    saving: {
      title: 'Enregistrement',
      text: `Votre travail s’enregistre de lui-même dans ce navigateur, sur cet appareil, et il est encore là quand vous revenez. « ${storage.projects} » a tout, chacun avec son nom. Si vous effacez les données de ce navigateur, il disparaît : gardez aussi dans un fichier ce à quoi vous tenez.`,
    },
    files: {
      title: 'Fichiers de projet',
      text: `Dans « ${storage.projects} », « ${storage.saveProject} » fait de tout un seul fichier, avec vos photos en taille réelle. Déposez-le sur la fenêtre, ici ou sur un autre appareil, pour continuer. Un PNG d’une page avec les données du projet s’ouvre de la même façon ; il retrouve ses photos sur cet appareil, ou les contient si vous avez choisi « ${pngStrings.cargoKind.photos} ».`,
    },
    export: {
      title: 'Exporter : PNG, JPEG, WebP, PDF',
      text: `« ${board.download} » enregistre la page à la taille d’impression, à partir de vos photos d’origine. « ${board.export} » a le JPEG, le WebP et le PDF, ainsi que la qualité. Plusieurs pages deviennent un PDF, un ZIP ou un CBZ pour lecteurs de BD.`,
    },
    comics: {
      title: 'BD à lire : HTML, EPUB, CBZ',
      text: `« ${board.export} » fait aussi des BD. « BD en HTML » est un fichier que tout le monde peut ouvrir dans un navigateur : touchez, balayez ou utilisez les flèches pour aller de case en case, voyez des pages entières ou lisez tout en texte. EPUB est pour les applis de lecture, CBZ pour les lecteurs de BD. Dans tous, l’ordre des cases est connu, avec leurs mots et, si cela a été trouvé, ce qu’elles montrent ; on peut donc les faire lire à voix haute.`,
    },
    privacy: {
      title: 'Hors connexion et privé',
      text: `Vos photos ne quittent jamais cet appareil : tout le travail se fait dans ce navigateur, et rien n’est envoyé nulle part. Les visages sont localisés pour que les cases ne les coupent pas ; personne n’est reconnu. La position d’une photo n’est lue que pour nommer son lieu dans les textes, avec une table de GeoNames (CC BY 4.0) ; les pages exportées ne la contiennent jamais. Après la première visite, Inkpanel marche aussi sans connexion. Là où le navigateur le peut, « ${offlineStrings.install} » lui donne sa propre fenêtre.`,
    },
    keyboard: {
      title: 'Au clavier',
      text: `Tout peut se faire sans souris ; les raccourcis sont plus bas. Les flèches vont de case en case, Entrée prend l’image de l’une d’elles, et les flèches la déplacent alors. Les lettres seules peuvent être désactivées comme raccourcis, pour qui parle à son ordinateur.`,
    },
  },
};
