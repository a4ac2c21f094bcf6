//! Measures the placement of text on rendered pages.

use inkpanel_engine::framing::{Crop, PhotoMeta};
use inkpanel_engine::layout::{Bounds, Point};
use inkpanel_engine::page::words::layout::{Ground, Laid, lay_all};
use inkpanel_engine::page::words::model::Kind;
use inkpanel_engine::page::words::{Letters, draw};
use inkpanel_engine::page::{Document, Patch};

/// Width at which pages are drawn to be measured.
const WIDTH: usize = 620;

/// Counts over several pages.
#[derive(Debug, Default, Clone)]
pub(crate) struct Figures {
    /// Balloons.
    pub(crate) balloons: usize,
    /// Visible faces in panels with text, and how many of them are partly covered by text or a tail.
    pub(crate) faces: (usize, usize),
    /// Area of bodies in panels with text, and the covered part of it.
    pub(crate) bodies: (f64, f64),
    /// Area of subject masks in panels with text, and the covered part of it.
    pub(crate) silhouettes: (f64, f64),
    /// Number of tails, and of tails that point to a mouth. Without a face, the largest subject counts.
    pub(crate) tails: (usize, usize),
    /// Text items that extend beyond their shape, or whose text is truncated.
    pub(crate) outside: usize,
    /// Pairs of text items that overlap.
    pub(crate) overlaps: usize,
    /// Words that cross the border of their panel.
    pub(crate) crossing: usize,
    /// Text items that are read before an earlier one.
    pub(crate) disorder: usize,
    /// Smallest and largest text size, in points on A4.
    pub(crate) points: Option<(f64, f64)>,
    /// Balloons that are linked to another one and share its tail.
    pub(crate) joined: usize,
    /// Descriptions of all faults.
    pub(crate) told: Vec<String>,
}

impl Figures {
    /// Adds the counts of another page.
    pub(crate) fn add(&mut self, other: Self) {
        self.balloons += other.balloons;
        self.faces = (self.faces.0 + other.faces.0, self.faces.1 + other.faces.1);
        self.bodies = (self.bodies.0 + other.bodies.0, self.bodies.1 + other.bodies.1);
        self.silhouettes =
            (self.silhouettes.0 + other.silhouettes.0, self.silhouettes.1 + other.silhouettes.1);
        self.tails = (self.tails.0 + other.tails.0, self.tails.1 + other.tails.1);
        self.outside += other.outside;
        self.overlaps += other.overlaps;
        self.crossing += other.crossing;
        self.disorder += other.disorder;
        self.joined += other.joined;
        self.points = match (self.points, other.points) {
            (Some(a), Some(b)) => Some((a.0.min(b.0), a.1.max(b.1))),
            (a, b) => a.or(b),
        };
        self.told.extend(other.told);
    }

    /// Share of the bodies' area that is covered, in percent.
    pub(crate) fn covered_bodies(&self) -> f64 {
        100.0 * self.bodies.1 / self.bodies.0.max(1e-9)
    }

    /// Returns the covered share of the subjects, in percent.
    pub(crate) fn covered_figures(&self) -> f64 {
        100.0 * self.silhouettes.1 / self.silhouettes.0.max(1e-9)
    }

    /// Tails that are right, in percent.
    pub(crate) fn right_tails(&self) -> f64 {
        100.0 * self.tails.1 as f64 / (self.tails.0 as f64).max(1.0)
    }
}

struct Seen {
    label: String,
    bounds: Bounds,
    /// The middle of its mouth.
    mouth: Point,
}

/// Measures a page. Descriptions of faults contain `name`.
///
/// # Errors
/// Errors of rendering.
pub(crate) fn measure(
    page: &Document,
    photos: &[PhotoMeta],
    letters: &Letters,
    name: &str,
) -> inkpanel_engine::Result<Figures> {
    let ground = Ground::new(page)?;
    let all = lay_all(page, letters)?;
    let patches: Vec<Patch> = (0..all.len())
        .map(|i| draw::render(page, i, WIDTH, letters))
        .collect::<inkpanel_engine::Result<_>>()?;
    let chains = chains(&all);
    let mut figures = Figures::default();
    let mut panels: Vec<usize> = all.iter().filter_map(|laid| laid.word.panel).collect();
    panels.sort_unstable();
    panels.dedup();
    for panel in panels {
        let frame = ground.panels[panel].bounds;
        let (area, covered_part) = figure_in(page, panel, frame, photos, &patches);
        figures.silhouettes = (figures.silhouettes.0 + area, figures.silhouettes.1 + covered_part);
        for seen in seen_in(page, &ground, panel, photos) {
            let (area, covered) = covered(&patches, inside(seen.bounds, frame));
            match seen.label.as_str() {
                "face" => {
                    figures.faces.0 += 1;
                    if covered > 0.0 {
                        figures.faces.1 += 1;
                        figures
                            .told
                            .push(format!("{name}: a face in panel {panel} is covered by {covered:.4}"));
                    }
                }
                "person" => {
                    figures.bodies.0 += area;
                    figures.bodies.1 += covered;
                }
                _ => {}
            }
        }
    }
    for (i, laid) in all.iter().enumerate() {
        let points = laid.setting.size * 210.0 / 25.4 * 72.0;
        figures.points =
            Some(figures.points.map_or((points, points), |(low, high)| (low.min(points), high.max(points))));
        if !matches!(laid.word.kind(), Kind::Balloon(_)) {
            continue;
        }
        figures.balloons += 1;
        if laid.setting.cut || !holds_its_text(laid, letters) {
            figures.outside += 1;
            figures.told.push(format!("{name}: word {i} is outside of its balloon"));
        }
        if laid.word.hangs_on().is_some() {
            figures.joined += 1;
        } else {
            figures.tails.0 += 1;
            let panel = laid.word.panel.unwrap_or(0);
            match wrong_tail(laid, &seen_in(page, &ground, panel, photos)) {
                None => figures.tails.1 += 1,
                Some(why) => figures.told.push(format!("{name}: the tail of word {i} {why}")),
            }
        }
        let frame = ground.frame(&laid.word);
        let (a, b) = laid.setting.half;
        if laid.middle.x - a < frame.x - 1e-6
            || laid.middle.x + a > frame.x + frame.width + 1e-6
            || laid.middle.y - b < frame.y - 1e-6
            || laid.middle.y + b > frame.y + frame.height + 1e-6
        {
            figures.crossing += 1;
            figures.told.push(format!("{name}: word {i} crosses the border of its panel"));
        }
        for (j, other) in all.iter().enumerate().skip(i + 1) {
            // The first balloon of a chain draws the outlines of the whole chain, so the balloons are checked
            // one by one.
            let chained = chains[i].is_some() && chains[i] == chains[j];
            let meet = if chained { ovals_meet(laid, other) } else { touching(&patches[i], &patches[j]) };
            if meet {
                figures.overlaps += 1;
                figures.told.push(format!("{name}: words {i} and {j} overlap"));
            }
            if laid.word.panel == other.word.panel && read_before(other, laid) {
                figures.disorder += 1;
                figures.told.push(format!("{name}: word {j} is read before word {i}"));
            }
        }
    }
    Ok(figures)
}

fn seen_in(page: &Document, ground: &Ground, panel: usize, photos: &[PhotoMeta]) -> Vec<Seen> {
    let content = &page.panels[panel];
    let Some(photo) = content.photo.as_ref().and_then(|id| photos.iter().find(|photo| photo.id == *id))
    else {
        return Vec::new();
    };
    let image = ground.panels[panel].bounds;
    let crop = content.crop.unwrap_or(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 });
    let (across, down) = (image.width / crop.width, image.height / crop.height);
    let seen = photo.subjects.iter().map(|subject| Seen {
        mouth: {
            let [x, y] = subject.mouth();
            Point::new(image.x + (x - crop.x) * across, image.y + (y - crop.y) * down)
        },
        label: subject.label.clone(),
        bounds: Bounds {
            x: image.x + (subject.x - crop.x) * across,
            y: image.y + (subject.y - crop.y) * down,
            width: subject.width * across,
            height: subject.height * down,
        },
    });
    // A subject that is mostly cut off does not count as visible.
    let shown = |seen: &Seen| {
        let part = inside(seen.bounds, image);
        part.width * part.height > 0.3 * seen.bounds.width * seen.bounds.height
    };
    seen.filter(shown).collect()
}

fn inside(a: Bounds, b: Bounds) -> Bounds {
    let (x, y) = (a.x.max(b.x), a.y.max(b.y));
    Bounds {
        x,
        y,
        width: ((a.x + a.width).min(b.x + b.width) - x).max(0.0),
        height: ((a.y + a.height).min(b.y + b.height) - y).max(0.0),
    }
}

fn opaque(patch: &Patch, x: i64, y: i64) -> bool {
    let (x, y) = (x - patch.area.x, y - patch.area.y);
    x >= 0
        && y >= 0
        && (x as usize) < patch.area.width
        && (y as usize) < patch.area.height
        && patch.rgba[(y as usize * patch.area.width + x as usize) * 4 + 3] > 127
}

/// Returns the area of a box in page widths squared, and the part that text covers.
fn covered(patches: &[Patch], bounds: Bounds) -> (f64, f64) {
    let scale = WIDTH as f64;
    let range = |start: f64, length: f64| {
        ((start * scale).ceil() as i64)..(((start + length) * scale).floor() as i64)
    };
    let mut count = 0;
    for y in range(bounds.y, bounds.height) {
        for x in range(bounds.x, bounds.width) {
            count += usize::from(patches.iter().any(|patch| opaque(patch, x, y)));
        }
    }
    (bounds.width * bounds.height, count as f64 / scale / scale)
}

/// Returns the area of the subject in a panel, by the mask of its photo, and the part that text covers,
/// counted in pixels of the mask.
fn figure_in(
    page: &Document,
    panel: usize,
    image: Bounds,
    photos: &[PhotoMeta],
    patches: &[Patch],
) -> (f64, f64) {
    let content = &page.panels[panel];
    let photo = content.photo.as_ref().and_then(|id| photos.iter().find(|photo| photo.id == *id));
    let Some(mask) = photo.and_then(|photo| photo.mask.as_ref()) else { return (0.0, 0.0) };
    let crop = content.crop.unwrap_or(Crop { x: 0.0, y: 0.0, width: 1.0, height: 1.0 });
    let plane = mask.plane();
    let cell =
        (image.width / crop.width / plane.width() as f64, image.height / crop.height / plane.height() as f64);
    let (mut all, mut under) = (0, 0);
    for y in 0..plane.height() {
        for x in 0..plane.width() {
            let part = |at: usize, of: usize| (at as f64 + 0.5) / of as f64;
            let across = (part(x, plane.width()) - crop.x) / crop.width;
            let down = (part(y, plane.height()) - crop.y) / crop.height;
            if plane.at(x, y) < 128 || !(0.0..1.0).contains(&across) || !(0.0..1.0).contains(&down) {
                continue;
            }
            let at = (image.x + across * image.width, image.y + down * image.height);
            let (left, top) = ((at.0 * WIDTH as f64) as i64, (at.1 * WIDTH as f64) as i64);
            all += 1;
            under += usize::from(patches.iter().any(|patch| opaque(patch, left, top)));
        }
    }
    (f64::from(all) * cell.0 * cell.1, under as f64 * cell.0 * cell.1)
}

fn touching(a: &Patch, b: &Patch) -> bool {
    (0..a.area.height as i64).any(|y| {
        (0..a.area.width as i64).any(|x| {
            let (x, y) = (x + a.area.x, y + a.area.y);
            opaque(a, x, y) && opaque(b, x, y)
        })
    })
}

/// Returns the first balloon of the chain of each text item; `None` for items without a link.
fn chains(all: &[Laid]) -> Vec<Option<usize>> {
    let before = |i: usize| {
        let name = all[i].word.hangs_on()?;
        all.iter().position(|laid| laid.word.id.as_ref() == Some(name))
    };
    let first = |i: usize| std::iter::successors(before(i), |&at| before(at)).last();
    let leads: Vec<Option<usize>> = (0..all.len()).map(first).collect();
    (0..all.len()).map(|i| leads[i].or_else(|| leads.contains(&Some(i)).then_some(i))).collect()
}

/// Whether the ovals of two balloons overlap.
fn ovals_meet(a: &Laid, b: &Laid) -> bool {
    let (one, other) = (a.setting.half, b.setting.half);
    let across = (a.middle.x - b.middle.x).abs() / (one.0 + other.0);
    let down = (a.middle.y - b.middle.y).abs() / (one.1 + other.1);
    across.powf(2.4) + down.powf(2.4) < 1.0
}

/// Returns whether all corners of all lines are inside of the oval. Bursts and clouds surround this oval.
fn holds_its_text(laid: &Laid, letters: &Letters) -> bool {
    let (a, b) = laid.setting.half;
    let capitals = letters.font(laid.word.font()).map_or(0.7, |font| font.capitals) * laid.setting.size;
    let last = (laid.setting.lines.len() as f64 - 1.0) / 2.0;
    laid.setting.lines.iter().enumerate().all(|(i, (_, width))| {
        let y = (i as f64 - last).abs() * laid.setting.pitch + capitals / 2.0;
        (width / 2.0 / a).powf(2.4) + (y / b).powf(2.4) < 1.0
    })
}

/// Returns the fault of a tail. It should point to a mouth, end before it, and not cross another subject.
fn wrong_tail(laid: &Laid, seen: &[Seen]) -> Option<String> {
    let Some(tip) = laid.tip else { return Some("is missing".into()) };
    let middle = laid.middle;
    let (a, b) = laid.setting.half;
    let norm =
        (((tip.x - middle.x) / a).abs().powf(2.4) + ((tip.y - middle.y) / b).abs().powf(2.4)).powf(1.0 / 2.4);
    if norm < 1.05 {
        return Some("is too short to be seen".into());
    }
    let foot = middle.toward(tip, 1.0 / norm);
    let heads: Vec<&Seen> = seen.iter().filter(|seen| seen.label == "face").collect();
    // Extends the line to the border of the panel.
    let far = Point::new(foot.x + (tip.x - foot.x) * 40.0, foot.y + (tip.y - foot.y) * 40.0);
    if heads.is_empty() {
        let bodies: Vec<&Seen> = seen.iter().filter(|seen| seen.label != "text").collect();
        let hit = bodies.is_empty() || bodies.iter().any(|seen| first_hit(foot, far, seen.bounds).is_some());
        return (!hit).then(|| "leads to nothing that is seen".into());
    }
    if heads.iter().any(|head| first_hit(foot, tip, head.bounds).is_some_and(|at| at < 0.999)) {
        return Some("crosses a face".into());
    }
    let hits = heads.iter().filter_map(|head| Some((first_hit(foot, far, head.bounds)?, head)));
    let Some((_, head)) = hits.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return Some("leads to no face".into());
    };
    let mouth = head.mouth;
    let nearer = heads
        .iter()
        .any(|other| !std::ptr::eq(*other, *head) && other.mouth.distance(tip) < 0.75 * mouth.distance(tip));
    if nearer {
        return Some("ends nearer to another mouth".into());
    }
    // Its line passes the lips within a tenth of the height of the face.
    let (dx, dy) = (tip.x - foot.x, tip.y - foot.y);
    let aside = ((mouth.x - foot.x) * dy - (mouth.y - foot.y) * dx).abs() / dx.hypot(dy).max(1e-9);
    if aside > head.bounds.height / 10.0 {
        return Some("leads past the mouth".into());
    }
    let way = foot.distance(tip) / foot.distance(mouth).max(1e-9);
    let until = first_hit(foot, mouth, head.bounds).unwrap_or(1.0);
    (way < until.min(0.5) - 0.05 || way > 0.65).then(|| format!("ends {:.0} % of the way", 100.0 * way))
}

/// How far along a line a box begins.
fn first_hit(from: Point, to: Point, bounds: Bounds) -> Option<f64> {
    (0..=4_000).map(|i| f64::from(i) / 4_000.0).find(|&part| {
        let at = from.toward(to, part);
        at.x >= bounds.x
            && at.x <= bounds.x + bounds.width
            && at.y >= bounds.y
            && at.y <= bounds.y + bounds.height
    })
}

/// Returns whether a text item is read before another: it is above, or next to it on the left.
fn read_before(a: &Laid, b: &Laid) -> bool {
    let half = |laid: &Laid| laid.setting.half.1;
    let common =
        (a.middle.y + half(a)).min(b.middle.y + half(b)) - (a.middle.y - half(a)).max(b.middle.y - half(b));
    if common > 0.3 * 2.0 * half(a).min(half(b)) { a.middle.x < b.middle.x } else { a.middle.y < b.middle.y }
}
