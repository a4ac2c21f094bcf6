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
  help: 'Hilfe und Tastenkürzel',
  helpShort: 'Hilfe',
  searchHelp: 'Hilfe durchsuchen',
  helpTopics: 'Themen',
  helpFound: (topics: number, keys: number) =>
    `Gefunden: ${topics === 1 ? '1 Thema' : `${topics} Themen`}, ${keys === 1 ? '1 Kürzel' : `${keys} Kürzel`}`,
  helpNone: (text: string) =>
    `Über „${text}“ steht hier nichts. Versuch ein anderes Wort, oder sieh alle Themen durch.`,
  allTopics: 'Alle Themen zeigen',
  hintsAgain: 'Die Tipps noch einmal zeigen',
  hint: {
    shuffle: 'Misch, bis es dir gefällt. Jede Seite, die du gesehen hast, lässt sich zurückholen.',
    crop: 'Zieh, um das Bild zu verschieben, und dreh das Mausrad, um zu zoomen.',
    cropTouch: 'Zieh, um das Bild zu verschieben, und zoome mit zwei Fingern.',
    lock: 'Fixiere, was dir gefällt. Mischen ändert nur den Rest.',
  },
  topics: {
    adding: {
      title: 'Fotos und Videos hinzufügen',
      text: `Lege Fotos oder Videos irgendwo auf dem Fenster ab, füge sie aus der Zwischenablage ein oder drücke „${photos.addPhotos}“. Willst du dich erst umsehen, nimm „${startStrings.trySamples}“. Weitere kannst du jederzeit hinzufügen.`,
    },
    films: {
      title: 'Einzelbilder eines Videos',
      text: `Aus einem Video nimmt Inkpanel einige Einzelbilder, die dann Fotos wie alle anderen sind. Drücke in der Liste der Fotos auf seinen Namen, um Anfang, Ende und Anzahl zu wählen; „${photos.takeFrames}“ übernimmt sie. Ein Panel mit einem Einzelbild kann auf ein früheres oder späteres wechseln. „${sounds.hear}“ unter „${side.sideTab.words}“ schlägt Soundwörter für das vor, was bei den Einzelbildern auf deinen Seiten zu hören ist.`,
    },
    shuffle: {
      title: 'Mischen',
      text: `„${board.shuffle}“ macht aus deinen Fotos eine neue Seite, mit anderem Layout und anderem Stil. Daneben ändern „${board.part.layout}“, „${board.part.style}“ und „${board.part.photos}“ nur diesen Teil. Auf dem Handy kannst du die Seite auch zur Seite wischen.`,
    },
    locks: {
      title: 'Fixieren, was bleiben soll',
      text: `Das Schloss neben „${board.part.layout}“, „${board.part.style}“ oder „${board.part.photos}“ hält diesen Teil fest, während du den Rest mischst. „${panels.lockPanel}“ behält das Foto eines Panels mit seinem Ausschnitt. Ein Foto mit Stern wird groß gezeigt, hier und bei jedem Mischen.`,
    },
    versions: {
      title: 'Zurückgehen und Lieblingsseiten',
      text: `„${board.undo}“ und „${board.redo}“ gehen durch alles, was du getan hast. „${board.previous}“ und „${board.next}“ gehen durch die Seiten, die du gesehen hast; die Zahl dazwischen zeigt sie alle. Das Herz merkt eine Seite als Lieblingsseite vor.`,
    },
    ideas: {
      title: 'Vorschläge',
      text: `Der Streifen unter der Seite, „${side.moreIdeas}“, zeigt andere Seiten aus denselben Fotos. Ein Klick übernimmt eine davon. Zeig auf eine, um sie groß zu sehen.`,
    },
    layouts: {
      title: 'Layouts',
      text: `Wähle ein Layout nach Familie und Zahl der Panels; „${side.surprise}“ erfindet eines. Mit „${side.editLayout}“ ziehst und neigst du die Trennlinien zwischen den Panels, verschiebst Einsätze und teilst oder entfernst Panels. „${side.saveLayout}“ speichert es als Datei und legt es unter „${side.myLayouts}“ ab.`,
    },
    joining: {
      title: 'Panels zusammenlegen und ein Foto über mehrere Panels',
      text: `Schalte „${panels.selectPanels}“ ein und wähle Panels, die sich berühren. „${panels.joinPanels}“ macht eines daraus, wenn sie zusammen die Form eines einzelnen haben. „${panels.merge}“ lässt die Panels stehen, und ein Bild geht durch alle; „${panels.split}“ trennt sie wieder.`,
    },
    crop: {
      title: 'Ein Bild verschieben und zoomen',
      text: `Zieh das Bild in seinem Panel, um es zu verschieben; mit dem Mausrad oder zwei Fingern zoomst du. Tippe bei Berührung das Panel zuerst an. Ein Doppelklick passt ein, worum es im Bild geht. „${panels.resetCrop}“ stellt den automatischen Ausschnitt wieder her. „${panels.rotatePhoto}“ richtet ein liegendes Foto auf, „${panels.flipPhoto}“ spiegelt es; beides ändert das Foto auf allen Seiten.`,
    },
    exchange: {
      title: 'Fotos tauschen',
      text: `Zieh ein Bild aus seinem Panel auf ein anderes, und die beiden tauschen den Platz; „${panels.swapPhoto}“ tut dasselbe mit Klicks. Klick ein Foto in der Liste an, dann ein Panel, und das Foto kommt dorthin. Nimm bei einem Foto in der Liste den Haken weg, um es auszulassen.`,
    },
    subject: {
      title: 'Berichtigen, was das Motiv ist',
      text: `„${panels.breakFrame}“, Stile nur für Motiv oder Hintergrund und Text, der Körper frei lässt, richten sich nach dem erkannten Motiv. Ist es falsch, öffnet es „${brush.correct}“ bei den Werkzeugen eines Panels oder der Pinsel an einem angeklickten Foto der Liste: Mal dazu, was zum Motiv gehört, nimm weg, was nicht dazugehört, oder wähl ein anderes Motiv. „${brush.found}“ kehrt zum erkannten Motiv zurück.`,
    },
    styles: {
      title: 'Stile',
      text: `Jeder Stil ist an einem deiner Fotos zu sehen. Suche nach dem Namen oder wähle eine Art; deine Favoriten und die zuletzt benutzten stehen vorn. „${designer.styleShuffle}“ sagt, woraus „${board.shuffle}“ schöpft.`,
    },
    designer: {
      title: 'Einen Stil machen: der Designer',
      text: `Ein Stil hat zwei Ebenen, eine für die Farben und eine für die Linien, und jede ist eine Reihe von Bausteinen. „${designer.addBlock}“ fügt einen hinzu, seine Regler verändern ihn, und „${designer.compare}“ zeigt, was geschehen ist. Zieh einen Baustein an seinen Platz oder füge ihn mit dem Plus zwischen zwei Karten ein. „${designer.saveStyle}“ legt ihn unter „${designer.myStyles}“ ab.`,
    },
    explorer: {
      title: 'Einen Stil finden: der Explorer',
      text: `Er beginnt mit erfundenen Stilen auf deinem eigenen Foto, und „${designer.generate}“ macht mehr davon. Ein Klick zeigt einen groß. Merke dir mit dem Herz, was dir gefällt, mach mit „${designer.breed}“ aus zweien neue und setze mit „${designer.useStyle}“ einen auf die Seite. Jeden davon kannst du im Designer verändern.`,
    },
    imitation: {
      title: 'Ein Stil aus einem Bild',
      text: `„${imitation.styleFromPicture}“ überträgt das Aussehen einer Comicseite, eines Drucks oder eines Gemäldes auf deine Fotos. Wähle das Bild dort oder lege es mit gedrückter Alt-Taste irgendwo ab. Nach wenigen Sekunden siehst du drei bis sechs Stile auf deinem eigenen Foto; nimm einen, speichere ihn oder verändere ihn im Designer.`,
    },
    words: {
      title: 'Textkästen, Sprechblasen und Soundwörter',
      text: `Unter „${side.sideTab.words}“ fügst du einen Textkasten, eine Sprechblase oder ein Soundwort hinzu; es kommt dorthin, wo es kein Gesicht verdeckt, wenn Platz ist. Zieh es, oder schreib nach einem Doppelklick hinein; mit dem Finger tippst du es noch einmal an. Auch Videos bringen Text mit: „${words.addSubtitles}“ liest eine Untertiteldatei.`,
    },
    alike: {
      title: 'Ähnliche und ausgeschlossene Fotos',
      text: `Von Fotos, die sich ähnlich sehen, wird das schärfste verwendet; die anderen werden ausgeschlossen, unscharfe auch. Sie stehen unter „${photos.setAside}“: Hake eines an, um es zu verwenden. Wie ähnlich sie sein müssen, sagst du unter „${photos.choice}“.`,
    },
    pages: {
      title: 'Mehrere Seiten',
      text: `„${book.add}“ fügt dem Storyboard eine Seite hinzu, aus Fotos, die noch keine Seite zeigt, solange es welche gibt. „${book.spreadAlbum}“ setzt alle Fotos auf so viele Seiten, wie sie brauchen. Seiten lassen sich verschieben, entfernen und in einen gemeinsamen Stil bringen.`,
    },
    paper: {
      title: 'Seitenformat und Ränder',
      text: `Bei den Einstellungen der Seite stehen das Format, von A4 bis zu eigenen Maßen, der Seitenrand, der Steg zwischen den Panels, die Rahmen, die runden Ecken und die Farben. Sie gelten für alle Seiten eines Storyboards.`,
    },
    saving: {
      title: 'Speichern',
      text: `Deine Arbeit wird von selbst in diesem Browser gespeichert, auf diesem Gerät, und ist wieder da, wenn du zurückkommst. Unter „${storage.projects}“ findest du alles, jedes mit seinem Namen. Löschst du die Daten dieses Browsers, ist sie weg: Bewahre, was dir lieb ist, auch als Datei auf.`,
    },
    files: {
      title: 'Projektdateien',
      text: `Unter „${storage.projects}“ macht „${storage.saveProject}“ aus allem eine Datei, mit deinen Fotos in voller Größe. Leg sie hier oder auf einem anderen Gerät auf dem Fenster ab, um weiterzumachen. Ein PNG einer Seite mit Projektdaten öffnet sich genauso; es findet seine Fotos auf diesem Gerät oder hat sie in sich, wenn du „${pngStrings.cargoKind.photos}“ gewählt hast.`,
    },
    export: {
      title: 'Exportieren: PNG, JPEG, WebP, PDF',
      text: `„${board.download}“ speichert die Seite in Druckgröße, aus deinen Originalfotos. Unter „${board.export}“ gibt es JPEG, WebP und PDF, dazu die Qualität. Mehrere Seiten werden ein PDF, ein ZIP oder ein CBZ für Comic-Leseprogramme.`,
    },
    comics: {
      title: 'Comics zum Lesen: HTML, EPUB, CBZ',
      text: `„${board.export}“ macht auch Comics. „HTML-Comic“ ist eine Datei, die alle in einem Browser öffnen können: Mit Tippen, Wischen oder den Pfeiltasten geht es von Panel zu Panel, dazu gibt es ganze Seiten und alles als Text. EPUB ist für Lese-Apps, CBZ für Comic-Leseprogramme. In allen ist jedes Panel in seiner Reihenfolge bekannt, mit seinem Text und, soweit es gefunden wurde, mit dem, was es zeigt; so lassen sie sich vorlesen.`,
    },
    privacy: {
      title: 'Offline und privat',
      text: `Deine Fotos verlassen dieses Gerät nie: Alle Arbeit geschieht in diesem Browser, und nichts wird irgendwohin geschickt. Gesichter werden gefunden, damit Panels sie nicht abschneiden; niemand wird erkannt. Der Ort in einem Foto wird nur gelesen, um ihn in Texten zu nennen, mit einer Tabelle von GeoNames (CC BY 4.0); exportierte Seiten enthalten ihn nie. Nach dem ersten Besuch geht Inkpanel auch ohne Verbindung. Wo der Browser es kann, gibt „${offlineStrings.install}“ ihm ein eigenes Fenster.`,
    },
    keyboard: {
      title: 'Mit der Tastatur',
      text: `Alles geht auch ohne Maus; die Kürzel stehen unten. Pfeile gehen von Panel zu Panel, Eingabe nimmt das Bild eines Panels, und Pfeile bewegen es dann. Einzelne Buchstaben lassen sich als Kürzel abschalten, für alle, die mit ihrem Computer sprechen.`,
    },
  },
};
