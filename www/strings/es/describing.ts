import type { Seen } from '../en/describing.ts';

/** One and many of what is found in photos. */
const NAMES: Record<string, [string, string]> = {
  person: ['una persona', 'personas'], bicycle: ['una bicicleta', 'bicicletas'], car: ['un coche', 'coches'], motorcycle: ['una moto', 'motos'],
  airplane: ['un avión', 'aviones'], bus: ['un autobús', 'autobuses'], train: ['un tren', 'trenes'], truck: ['un camión', 'camiones'], boat: ['un barco', 'barcos'],
  'traffic light': ['un semáforo', 'semáforos'], 'fire hydrant': ['una boca de incendios', 'bocas de incendios'],
  'stop sign': ['una señal de stop', 'señales de stop'], 'parking meter': ['un parquímetro', 'parquímetros'], bench: ['un banco', 'bancos'],
  bird: ['un pájaro', 'pájaros'], cat: ['un gato', 'gatos'], dog: ['un perro', 'perros'], horse: ['un caballo', 'caballos'], sheep: ['una oveja', 'ovejas'],
  cow: ['una vaca', 'vacas'], elephant: ['un elefante', 'elefantes'], bear: ['un oso', 'osos'], zebra: ['una cebra', 'cebras'],
  giraffe: ['una jirafa', 'jirafas'], backpack: ['una mochila', 'mochilas'], umbrella: ['un paraguas', 'paraguas'], handbag: ['un bolso', 'bolsos'],
  tie: ['una corbata', 'corbatas'], suitcase: ['una maleta', 'maletas'], frisbee: ['un disco volador', 'discos voladores'],
  skis: ['unos esquís', 'pares de esquís'], snowboard: ['una tabla de nieve', 'tablas de nieve'], 'sports ball': ['un balón', 'balones'],
  kite: ['una cometa', 'cometas'], 'baseball bat': ['un bate de béisbol', 'bates de béisbol'], 'baseball glove': ['un guante de béisbol', 'guantes de béisbol'],
  skateboard: ['un monopatín', 'monopatines'], surfboard: ['una tabla de surf', 'tablas de surf'], 'tennis racket': ['una raqueta de tenis', 'raquetas de tenis'],
  bottle: ['una botella', 'botellas'], 'wine glass': ['una copa de vino', 'copas de vino'], cup: ['una taza', 'tazas'], fork: ['un tenedor', 'tenedores'],
  knife: ['un cuchillo', 'cuchillos'], spoon: ['una cuchara', 'cucharas'], bowl: ['un cuenco', 'cuencos'], banana: ['un plátano', 'plátanos'],
  apple: ['una manzana', 'manzanas'], sandwich: ['un sándwich', 'sándwiches'], orange: ['una naranja', 'naranjas'], broccoli: ['brócoli', 'brócolis'],
  carrot: ['una zanahoria', 'zanahorias'], 'hot dog': ['un perrito caliente', 'perritos calientes'], pizza: ['una pizza', 'pizzas'], donut: ['un dónut', 'dónuts'],
  cake: ['una tarta', 'tartas'], chair: ['una silla', 'sillas'], couch: ['un sofá', 'sofás'], 'potted plant': ['una planta en maceta', 'plantas en maceta'],
  bed: ['una cama', 'camas'], 'dining table': ['una mesa', 'mesas'], toilet: ['un inodoro', 'inodoros'], tv: ['un televisor', 'televisores'],
  laptop: ['un portátil', 'portátiles'], mouse: ['un ratón de ordenador', 'ratones de ordenador'], remote: ['un mando a distancia', 'mandos a distancia'],
  keyboard: ['un teclado', 'teclados'], 'cell phone': ['un móvil', 'móviles'], microwave: ['un microondas', 'microondas'], oven: ['un horno', 'hornos'],
  toaster: ['una tostadora', 'tostadoras'], sink: ['un fregadero', 'fregaderos'], refrigerator: ['una nevera', 'neveras'], book: ['un libro', 'libros'],
  clock: ['un reloj', 'relojes'], vase: ['un jarrón', 'jarrones'], scissors: ['unas tijeras', 'pares de tijeras'], 'teddy bear': ['un oso de peluche', 'osos de peluche'],
  'hair drier': ['un secador', 'secadores'], toothbrush: ['un cepillo de dientes', 'cepillos de dientes'],
};
const NUMBERS = ['', '', 'dos', 'tres', 'cuatro', 'cinco', 'seis', 'siete', 'ocho', 'nueve', 'diez', 'once', 'doce'];

function several({ label, count }: Seen) {
  const [one, many] = NAMES[label] ?? [label, label];
  return count === 1 ? one : `${NUMBERS[count] ?? count} ${many}`;
}

const list = new Intl.ListFormat('es');

export const describingStrings = {
  seen: (things: readonly Seen[]) => list.format(things.map(several)),
  pageHolds: (panels: number, layout: string, style: string) => `${panels === 1 ? 'Una viñeta' : `${panels} viñetas`}, plantilla ${layout}, estilo ${style}`,
  panelHolds: (n: number, what: string) => `Viñeta ${n}: ${what}.`,
  pageAs: (panels: number, style: string) => `Una página de ${panels === 1 ? 'una viñeta' : `${panels} viñetas`} con el estilo ${style}.`,
  wordSays: (kind: string, text: string) => `${kind}: «${text}».`,
  somePhoto: 'una foto',
  emptyPanel: 'vacía',
  ownLayout: 'propia',
  ownStyle: 'propio',
  description: 'Descripción de la página',
  copyDescription: 'Copiar descripción',
  descriptionHelp: 'Para quien no puede verla, dondequiera que muestres la página.',
  descriptionCopied: 'La descripción está en el portapapeles.',
  descriptionNotCopied: (text: string) => `Aquí no se puede usar el portapapeles. La descripción es: ${text}`,

  language: 'Idioma',
  languageHelp: 'La página se carga otra vez en ese idioma. Antes se guarda tu trabajo.',
  languageLater: (name: string) => `${name} queda para la próxima visita: tu trabajo no está guardado, así que la página no se ha cargado otra vez.`,
};
