//! Tagged-PDF structure for screen readers: the document and its pages in reading order. Each page has panels
//! as PDF figures with alternative text, and text items as paragraphs after their panel.
//!
//! Source: ISO 32000-1, sections 14.6 to 14.8.

use pdf_writer::types::{ArtifactType, StructRole};
use pdf_writer::{Content, Finish, Name, Pdf, Ref, TextStr};

/// Something that is read.
struct Element {
    /// The page of the storyboard that it is on, from 0.
    leaf: usize,
    /// Its place there: the panel, then down and across.
    rank: (i64, f64),
    role: StructRole,
    /// Alternative text of a PDF figure, or text of a paragraph.
    text: String,
    /// The sheet that it is drawn on.
    page: Ref,
    /// Its number there.
    number: i32,
    id: Ref,
}

/// All that is read in a file.
#[derive(Default)]
pub(super) struct Tags {
    elements: Vec<Element>,
    /// The sheets in their order, and the elements of each by their numbers.
    sheets: Vec<(Ref, Vec<Ref>)>,
}

impl Tags {
    /// Begins a sheet. The next marked content is on it.
    pub(super) fn begin(&mut self, page: Ref) {
        self.sheets.push((page, Vec::new()));
    }

    /// The key of the sheet that was begun last.
    pub(super) fn key(&self) -> i32 {
        self.sheets.len() as i32 - 1
    }

    /// A panel that shows something, with its page and its rank there. The content until [`end`] belongs to
    /// it.
    pub(super) fn figure(&mut self, content: &mut Content, (leaf, panel): (usize, i64), alt: &str, id: Ref) {
        self.mark(content, (leaf, (panel, f64::NEG_INFINITY)), StructRole::Figure, alt, id);
    }

    /// Begins a text item. The content until [`end`] is its glyphs.
    pub(super) fn paragraph(
        &mut self,
        content: &mut Content,
        place: (usize, (i64, f64)),
        says: &str,
        id: Ref,
    ) {
        self.mark(content, place, StructRole::P, says, id);
    }

    fn mark(
        &mut self,
        content: &mut Content,
        (leaf, rank): (usize, (i64, f64)),
        role: StructRole,
        text: &str,
        id: Ref,
    ) {
        let Some((page, on_it)) = self.sheets.last_mut() else { return };
        let number = on_it.len() as i32;
        on_it.push(id);
        let name: &[u8] = if role == StructRole::Figure { b"Figure" } else { b"P" };
        content.begin_marked_content_with_properties(Name(name)).properties().identify(number);
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        self.elements.push(Element { leaf, rank, role, text, page: *page, number, id });
    }

    /// Writes the tree; `root` is what the catalog names.
    pub(super) fn write(mut self, pdf: &mut Pdf, root: Ref, leaves: usize, next: &mut impl FnMut() -> Ref) {
        self.elements
            .sort_by(|a, b| (a.leaf, a.rank.0).cmp(&(b.leaf, b.rank.0)).then(a.rank.1.total_cmp(&b.rank.1)));
        let document = next();
        let sections: Vec<(usize, Ref)> = (0..leaves)
            .filter(|leaf| self.elements.iter().any(|element| element.leaf == *leaf))
            .map(|leaf| (leaf, next()))
            .collect();
        let lists: Vec<Ref> = self.sheets.iter().map(|_| next()).collect();
        let mut tree = pdf.indirect(root).start::<pdf_writer::writers::StructTreeRoot>();
        tree.child(document);
        let mut parents = tree.parent_tree();
        let mut keys = parents.nums();
        for (key, list) in lists.iter().enumerate() {
            keys.insert(key as i32, *list);
        }
        keys.finish();
        parents.finish();
        tree.parent_tree_next_key(lists.len() as i32);
        tree.finish();
        for ((_, elements), list) in self.sheets.iter().zip(lists) {
            pdf.indirect(list).array().items(elements.iter().copied());
        }
        let mut whole = pdf.struct_element(document);
        whole.kind(StructRole::Document).parent(root);
        let mut children = whole.children();
        for (_, section) in &sections {
            children.struct_element(*section);
        }
        children.finish();
        whole.finish();
        for (leaf, section) in sections {
            let own = || self.elements.iter().filter(move |element| element.leaf == leaf);
            let mut element = pdf.struct_element(section);
            element.kind(StructRole::Sect).parent(document);
            let mut children = element.children();
            for child in own() {
                children.struct_element(child.id);
            }
            children.finish();
            element.finish();
            for child in own() {
                write_element(pdf, child, section);
            }
        }
    }
}

fn write_element(pdf: &mut Pdf, element: &Element, parent: Ref) {
    let mut written = pdf.struct_element(element.id);
    written.kind(element.role).parent(parent).page(element.page);
    if element.role == StructRole::Figure {
        written.alt(TextStr(&element.text));
    } else {
        written.actual_text(TextStr(&element.text));
    }
    written.children().marked_content_id(element.number);
}

/// Begins content without meaning: paper, lines, marks. It lasts until [`end`].
pub(super) fn artifact(content: &mut Content) {
    let mut mark = content.begin_marked_content_with_properties(Name(b"Artifact"));
    mark.properties().artifact().kind(ArtifactType::Layout);
}

/// Ends the current marked content.
pub(super) fn end(content: &mut Content) {
    content.end_marked_content();
}
