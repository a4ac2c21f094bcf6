//! Metadata of a PDF file: title, language, and the sRGB output intent. Dates and authors are not written,
//! for privacy.

use super::options::Options;
use super::packed;
use crate::page::srgb;
use pdf_writer::types::OutputIntentSubtype;
use pdf_writer::{Filter, Finish, Pdf, Ref, TextStr};

const PRODUCER: &str = "Inkpanel";
const SPACE: &str = "sRGB IEC61966-2.1";

/// The objects that the catalog names.
pub(super) struct About {
    metadata: Ref,
    profile: Ref,
    /// The root of the structure, see `tags`.
    pub(super) structure: Ref,
    /// Whether there are colours to speak of.
    colored: bool,
}

impl About {
    pub(super) fn new(options: &Options, next: &mut impl FnMut() -> Ref) -> Self {
        let [metadata, profile, structure] = [next(), next(), next()];
        Self { metadata, profile, structure, colored: options.plate.is_none() }
    }

    /// Writes the catalog and its objects, except the pages.
    pub(super) fn write(
        &self,
        pdf: &mut Pdf,
        (catalog, tree): (Ref, Ref),
        info: Ref,
        (options, rtl): (&Options, bool),
    ) {
        let mut root = pdf.catalog(catalog);
        root.pages(tree).metadata(self.metadata);
        root.pair(pdf_writer::Name(b"StructTreeRoot"), self.structure);
        root.mark_info().marked(true);
        if !options.language.is_empty() {
            root.lang(TextStr(&options.language));
        }
        let mut preferences = root.viewer_preferences();
        preferences.display_doc_title(true);
        if rtl {
            preferences.direction(pdf_writer::types::Direction::R2L);
        }
        preferences.finish();
        if self.colored {
            let mut intents = root.output_intents();
            let mut intent = intents.push();
            intent.subtype(OutputIntentSubtype::PDFA);
            intent.output_condition_identifier(TextStr(SPACE)).info(TextStr(SPACE));
            intent.dest_output_profile(self.profile);
        }
        root.finish();
        pdf.document_info(info).title(TextStr(&options.title)).producer(TextStr(PRODUCER));
        let about = metadata(options);
        pdf.metadata(self.metadata, about.as_bytes()).finish();
        if self.colored {
            let small = packed(srgb::profile());
            let mut profile = pdf.icc_profile(self.profile, &small);
            profile.n(3).range([0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
            profile.filter(Filter::FlateDecode);
        }
    }
}

/// The metadata as XMP. Source: ISO 16684-1.
fn metadata(options: &Options) -> String {
    let title = escaped(&options.title);
    let language = match escaped(&options.language) {
        told if told.is_empty() => told,
        told => format!("<dc:language><rdf:Bag><rdf:li>{told}</rdf:li></rdf:Bag></dc:language>"),
    };
    format!(
        "<?xpacket begin=\"\u{feff}\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n\
         <x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\
         <rdf:Description rdf:about=\"\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" \
         xmlns:pdf=\"http://ns.adobe.com/pdf/1.3/\"><dc:format>application/pdf</dc:format>\
         <dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">{title}</rdf:li></rdf:Alt></dc:title>{language}\
         <pdf:Producer>{PRODUCER}</pdf:Producer></rdf:Description></rdf:RDF></x:xmpmeta>\n<?xpacket end=\"r\"?>"
    )
}

/// Escapes a text for XML, without characters that XML does not allow.
fn escaped(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => {}
            letter if letter.is_control() => out.push(' '),
            letter => out.push(letter),
        }
    }
    out
}
