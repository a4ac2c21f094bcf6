//! Faces: `BlazeFace` (Bazarevsky et al., "Sub-millisecond Neural Face Detection on Mobile GPUs"), the
//! full-range model. Its input is 192 x 192 pixels, and it finds faces from about a tenth of that side.

use super::letterbox::{Letterbox, letterbox, letterbox_with_margin};
use super::model::Net;
use super::ssd::{Candidate, corners, sigmoid, suppress, suppress_parts};
use super::{Detection, light};
use inkpanel_image::error::{Error, Result};
use inkpanel_image::raster::Image;
use inkpanel_image::raster::resize::Region;

/// Label of faces in framing.
pub(super) const LABEL: &str = "face";
/// Label of persons among the objects.
const PERSON: &str = "person";

const SIDE: usize = 192;
/// Cells along each side, with one anchor each.
const CELLS: usize = 48;
/// Numbers per anchor: the box, and the six points of the face.
const NUMBERS: usize = 16;
const THRESHOLD: f64 = 0.5;
/// Parts of a photo give more false faces.
const CLOSER_THRESHOLD: f64 = 0.7;
const SAME: f64 = 0.3;

/// Parts of a photo along each side, and the overlap of neighbours in sides of a part.
const QUARTERS: (usize, f64) = (2, 1.0 / 3.0);
/// The same for ninths, which find most faces of a large group.
const NINTHS: (usize, f64) = (3, 0.25);
/// Sides of a part in its shorter sides, at most. A panorama has more parts along its longer side, because the model sees each
/// part in a square.
const LONGEST_PART: f64 = 1.9;
const MOST_PARTS: usize = 8;
/// Minimum longer side, in pixels, at which parts of a photo can show more faces.
const LARGE: usize = 2 * SIDE;
/// A face below this share of the photo is small. If there is one, others may be too small for the first
/// search.
const SMALL: f64 = 0.12;
/// The same for ninths of the photo: the height of a small face in heights of the photo, or in its longer sides.
const LARGER: usize = 4 * SIDE;
const SMALLER: (f64, f64) = (0.07, 0.05);
/// Score below which the photo is searched again with a margin. A face that fills the photo is too large for the model, so
/// the model misses it or is unsure.
const UNSURE: f64 = 0.78;
/// Side of the photo inside its margin, in pixels, and the minimum height of a face that this search adds.
const INNER: usize = SIDE / 2;
const FILLING: f64 = 0.25;
/// Sides of the squares that are searched for the face of a person, in shorter sides of the person's box. The model misses faces
/// without surroundings, and small faces in a large square. The second square is searched if the first shows no face.
const AROUND_HEAD: [f64; 2] = [2.4, 1.2];
/// Share of such a square above the person's box, which often cuts the hair.
const ABOVE_HEAD: f64 = 0.12;
/// Minimum score of the face of a person.
const OF_PERSON: f64 = 0.6;
/// Part of the score that such a face keeps. It is often turned, masked or blurred. Plans then value its person like one without
/// a face, unless the face is very certain, and styles and crops protect the face.
const UNCLEAR: f64 = 0.7;
/// The face of a person lies in this share of the box: the middle of the width, and the upper part of the height.
const HEAD: (f64, f64) = (0.7, 0.55);
/// Persons whose faces are searched at most, and the minimum shorter side of a person in longer sides of the photo. The faces
/// of smaller persons are unreadable on a page.
const PERSONS: usize = 16;
const FAR: f64 = 0.04;
/// A box of a part that ends this near to an inner edge is cut by it, in sides of the photo.
const EDGE: f64 = 0.004;

/// The face detector.
pub struct Faces {
    net: Net,
}

impl Faces {
    /// Loads the model (an ONNX file).
    ///
    /// # Errors
    /// `detector` if the file is not the expected model.
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Net::new(onnx, SIDE)? })
    }

    /// Detects faces in a single pass over the whole photo, the most certain first.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn look(&self, photo: &Image) -> Result<Vec<Detection>> {
        let whole = Region::whole(photo.width(), photo.height());
        Ok(detections(suppress(self.candidates(photo, whole, THRESHOLD)?, SAME)))
    }

    /// Detects faces in the whole photo. Without a certain face, it also searches faces that fill the photo.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn search(&self, photo: &Image) -> Result<Vec<Detection>> {
        let mut found = self.look(photo)?;
        if !found.iter().any(|face| face.score >= UNSURE) {
            found = self.with_filling(photo, &found)?;
        }
        light::add(photo, &mut found);
        Ok(found)
    }

    /// Returns `first` and the faces that fill the photo.
    fn with_filling(&self, photo: &Image, first: &[Detection]) -> Result<Vec<Detection>> {
        let whole = Region::whole(photo.width(), photo.height());
        let input = letterbox_with_margin(photo, whole, self.net.side(), INNER);
        let large = |candidate: &Candidate| candidate.corners[3] - candidate.corners[1] >= FILLING;
        let found = self.read(input, CLOSER_THRESHOLD)?.into_iter().filter(large);
        Ok(detections(suppress(candidates(first).chain(found).collect(), SAME)))
    }

    /// Returns all faces. If the largest face is small, it searches overlapping quarters or ninths of the photo. It also
    /// searches the heads of persons without a face in `first`. The result replaces `first`.
    ///
    /// `objects` are the detected objects of the photo. Other labels than `person` are ignored.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn look_closer(
        &self,
        photo: &Image,
        first: &[Detection],
        objects: &[Detection],
    ) -> Result<Vec<Detection>> {
        let mut all: Vec<Candidate> = candidates(first).collect();
        if worth_a_closer_look(photo, first) {
            all.extend(self.in_parts(photo, QUARTERS)?);
            if worth_the_closest_look(photo, &all) {
                all.extend(self.in_parts(photo, NINTHS)?);
            }
        }
        for person in objects.iter().filter(|object| is_near_person(photo, object)).take(PERSONS) {
            for around in AROUND_HEAD {
                if !all.iter().any(|face| is_face_of(person, face.corners)) {
                    let found = self.in_region(photo, head_of(person, photo, around), OF_PERSON)?;
                    all.extend(
                        found.into_iter().map(|face| Candidate { score: UNCLEAR * face.score, ..face }),
                    );
                }
            }
        }
        if all.len() == first.len() {
            return Ok(first.to_vec());
        }
        let mut found = detections(suppress_parts(all, SAME));
        light::add(photo, &mut found);
        Ok(found)
    }

    /// The faces in overlapping parts of a photo.
    fn in_parts(&self, photo: &Image, parts: (usize, f64)) -> Result<Vec<Candidate>> {
        let mut all = Vec::new();
        for region in parts_of(sides(photo), parts) {
            all.extend(self.in_region(photo, region, CLOSER_THRESHOLD)?);
        }
        Ok(all)
    }

    /// The faces in a region of a photo that its edges do not cut.
    fn in_region(&self, photo: &Image, region: Region, threshold: f64) -> Result<Vec<Candidate>> {
        let [width, height] = sides(photo);
        let [x, y] = [region.x / width, region.y / height];
        let edges = [x, y, x + region.width / width, y + region.height / height];
        let found = self.candidates(photo, region, threshold)?;
        Ok(found.into_iter().filter(|candidate| whole_in(candidate.corners, edges)).collect())
    }

    fn candidates(&self, photo: &Image, region: Region, threshold: f64) -> Result<Vec<Candidate>> {
        self.read(letterbox(photo, region, self.net.side()), threshold)
    }

    /// Runs the model on an input, and returns the faces above a score.
    fn read(&self, (input, place): (Vec<f32>, Letterbox), threshold: f64) -> Result<Vec<Candidate>> {
        let [boxes, logits] = self.net.run(&input)?;
        if boxes.len() != CELLS * CELLS * NUMBERS || logits.len() != CELLS * CELLS {
            return Err(Error::Detector("the file is not the face detector".into()));
        }
        let mut found = Vec::new();
        for (cell, (numbers, logit)) in boxes.chunks_exact(NUMBERS).zip(&logits).enumerate() {
            let score = sigmoid(*logit);
            // Not `score < threshold`, so that NaN values count as no detection.
            if score > threshold {
                let centre = |at: usize| (at as f64 + 0.5) / CELLS as f64;
                let number = |i: usize| f64::from(numbers[i]) / SIDE as f64;
                let at = |i: usize| [centre(cell % CELLS) + number(i), centre(cell / CELLS) + number(i + 1)];
                let [across, down] = at(0);
                let points = std::array::from_fn(|point| place.point_to_photo(at(4 + 2 * point)));
                found.push(Candidate {
                    corners: place.to_photo(corners(across, down, number(2), number(3))),
                    score,
                    points: Some(points),
                });
            }
        }
        Ok(found)
    }
}

/// Whether parts of the photo may show more faces: when none was found, or the largest is small.
pub fn worth_a_closer_look(photo: &Image, faces: &[Detection]) -> bool {
    let largest = faces.iter().map(|face| face.width.max(face.height)).fold(0.0, f64::max);
    photo.width().max(photo.height()) >= LARGE && largest < SMALL
}

/// Whether ninths of the photo may show more faces: when there is a very small one.
fn worth_the_closest_look(photo: &Image, faces: &[Candidate]) -> bool {
    let smallest = faces.iter().map(|face| face.corners[3] - face.corners[1]).fold(f64::INFINITY, f64::min);
    let [width, height] = sides(photo);
    let longer = width.max(height);
    longer >= LARGER as f64 && smallest * height < (SMALLER.0 * height).max(SMALLER.1 * longer)
}

/// Overlapping parts of a photo, row by row. `count`: parts along the shorter side. `overlap`: of neighbours, in sides of a part.
fn parts_of([width, height]: [f64; 2], (count, overlap): (usize, f64)) -> Vec<Region> {
    let part = |count: usize| 1.0 / (count as f64 - (count - 1) as f64 * overlap);
    let along = |side: f64, other: f64| {
        let longest = LONGEST_PART * part(count) * other;
        (count..MOST_PARTS).find(|more| part(*more) * side <= longest).unwrap_or(MOST_PARTS)
    };
    let (columns, rows) = (along(width, height), along(height, width));
    let start = |at: usize, count: usize| at as f64 * (1.0 - overlap) * part(count);
    let region = |at: usize| Region {
        x: start(at % columns, columns) * width,
        y: start(at / columns, rows) * height,
        width: part(columns) * width,
        height: part(rows) * height,
    };
    (0..columns * rows).map(region).collect()
}

fn sides(photo: &Image) -> [f64; 2] {
    [photo.width() as f64, photo.height() as f64]
}

/// Whether an object is a person whose face can be large enough.
fn is_near_person(photo: &Image, object: &Detection) -> bool {
    let [width, height] = sides(photo);
    let shorter = (object.width * width).min(object.height * height);
    object.label == PERSON && shorter >= FAR * width.max(height)
}

/// Whether a face is where the face of a person is.
fn is_face_of(person: &Detection, [left, top, right, bottom]: [f64; 4]) -> bool {
    let aside = (f64::midpoint(left, right) - person.x - person.width / 2.0).abs();
    let below = f64::midpoint(top, bottom) - person.y;
    aside <= HEAD.0 / 2.0 * person.width && (0.0..=HEAD.1 * person.height).contains(&below)
}

/// A square round the head of a person, `around` times as long as the shorter side of the person, and cut off at the photo's edges.
fn head_of(person: &Detection, photo: &Image, around: f64) -> Region {
    let [width, height] = sides(photo);
    let side = around * (person.width * width).min(person.height * height);
    let left = (person.x + person.width / 2.0) * width - side / 2.0;
    let top = person.y * height - ABOVE_HEAD * side;
    let [x, y] = [left.max(0.0), top.max(0.0)];
    Region { x, y, width: (left + side).min(width) - x, height: (top + side).min(height) - y }
}

/// Returns whether a box is not cut by an edge of its part. The edges of the photo do not count.
fn whole_in(corners: [f64; 4], edges: [f64; 4]) -> bool {
    (0..4).all(|side| {
        let of_photo = edges[side] <= 0.0 || edges[side] >= 1.0;
        of_photo || (corners[side] - edges[side]).abs() > EDGE
    }) && (corners[0] > edges[0] - EDGE && corners[2] < edges[2] + EDGE)
        && (corners[1] > edges[1] - EDGE && corners[3] < edges[3] + EDGE)
}

fn candidates(faces: &[Detection]) -> impl Iterator<Item = Candidate> + '_ {
    faces.iter().map(|f| Candidate {
        corners: [f.x, f.y, f.x + f.width, f.y + f.height],
        score: f.score,
        points: f.points,
    })
}

fn detections(candidates: Vec<Candidate>) -> Vec<Detection> {
    let detection = |Candidate { corners: [left, top, right, bottom], score, points }| Detection {
        label: LABEL.to_owned(),
        score,
        x: left,
        y: top,
        width: right - left,
        height: bottom - top,
        points,
        expression: None,
        light: None,
    };
    candidates.into_iter().map(detection).filter(|face| face.width > 0.0 && face.height > 0.0).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_image::raster::Plane;

    #[test]
    fn parts_cover_a_photo_and_a_panorama_has_more() {
        for (sides, parts, count) in [
            ([300.0, 200.0], QUARTERS, 4),
            ([160.0, 90.0], NINTHS, 9),
            ([250.0, 100.0], QUARTERS, 6),
            ([100.0, 250.0], QUARTERS, 6),
            ([250.0, 100.0], NINTHS, 15),
            ([9000.0, 100.0], NINTHS, 24),
        ] {
            let regions = parts_of(sides, parts);
            assert_eq!(regions.len(), count, "{sides:?}");
            let end = |of: fn(&Region) -> f64| regions.iter().map(of).fold(0.0, f64::max);
            assert!((end(|part| part.x + part.width) - sides[0]).abs() < 1e-9);
            assert!((end(|part| part.y + part.height) - sides[1]).abs() < 1e-9);
            let is_wide = |part: &Region| part.width > LONGEST_PART * part.height + 1e-9;
            assert!(count == 24 || !regions.iter().any(is_wide));
        }
        let quarters = parts_of([1.0, 1.0], QUARTERS);
        assert!((quarters[0].width - 0.6).abs() < 1e-9 && (quarters[3].x - 0.4).abs() < 1e-9);
    }

    #[test]
    fn a_face_that_an_inner_edge_cuts_is_left_to_the_other_part() {
        let left_part = [0.0, 0.0, 0.6, 0.6];
        assert!(whole_in([0.4, 0.1, 0.58, 0.3], left_part));
        assert!(!whole_in([0.4, 0.1, 0.6, 0.3], left_part));
        assert!(!whole_in([0.4, 0.5, 0.5, 0.63], left_part));
        // At the photo's own edge it is the photo that cuts it.
        assert!(whole_in([0.0, 0.1, 0.2, 0.3], left_part));
    }

    fn object(label: &str, [x, y, width, height]: [f64; 4]) -> Detection {
        let label = label.to_owned();
        Detection { label, score: 0.9, x, y, width, height, points: None, expression: None, light: None }
    }

    fn gray(width: usize, height: usize) -> Image {
        let plane = Plane::filled(width, height, 0);
        Image::from_rgb([plane.clone(), plane.clone(), plane]).unwrap()
    }

    #[test]
    fn the_head_of_a_person_is_in_a_square_at_the_top_of_the_box() {
        let photo = gray(1000, 500);
        let person = object(PERSON, [0.5, 0.4, 0.1, 0.6]);
        // The box is 100 pixels wide and 300 high, and 200 from the top.
        let region = head_of(&person, &photo, 1.5);
        let expected = [475.0, 182.0, 150.0, 150.0];
        let found = [region.x, region.y, region.width, region.height];
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
        // The photo ends right of this person, and above.
        let region = head_of(&object(PERSON, [0.9, 0.0, 0.1, 0.6]), &photo, 2.0);
        let found = [region.x, region.y, region.width, region.height];
        let expected = [850.0, 0.0, 150.0, 176.0];
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?}");
    }

    #[test]
    fn a_face_belongs_to_a_person_if_it_is_where_the_head_is() {
        let person = object(PERSON, [0.2, 0.2, 0.4, 0.8]);
        let face = |x: f64, y: f64| is_face_of(&person, [x - 0.05, y - 0.05, x + 0.05, y + 0.05]);
        assert!(face(0.4, 0.3) && face(0.29, 0.6));
        assert!(!face(0.22, 0.3) && !face(0.4, 0.7) && !face(0.4, 0.1));
    }

    #[test]
    fn only_persons_that_are_near_are_searched() {
        let photo = gray(1000, 500);
        assert!(is_near_person(&photo, &object(PERSON, [0.0, 0.0, 0.05, 0.5])));
        assert!(!is_near_person(&photo, &object(PERSON, [0.0, 0.0, 0.03, 0.5])));
        assert!(!is_near_person(&photo, &object("dog", [0.0, 0.0, 0.5, 0.5])));
    }

    #[test]
    fn the_closest_look_is_for_large_photos_with_a_very_small_face() {
        let photo = |side: usize| gray(side, side / 2);
        let face =
            |size: f64| Candidate { corners: [0.1, 0.1, 0.1 + size, 0.1 + size], score: 0.9, points: None };
        // A false face in the background is larger than the faces of the group.
        assert!(worth_the_closest_look(&photo(1600), &[face(0.1), face(0.05)]));
        assert!(!worth_the_closest_look(&photo(1600), &[face(0.1)]));
        assert!(!worth_the_closest_look(&photo(1600), &[]));
        assert!(!worth_the_closest_look(&photo(700), &[face(0.05)]));
    }

    #[test]
    fn a_closer_look_is_for_large_photos_with_small_faces_or_none() {
        let photo = |side: usize| gray(side, side / 2);
        let face = |size: f64| object(LABEL, [0.1, 0.1, size, size]);
        assert!(worth_a_closer_look(&photo(1600), &[]));
        assert!(worth_a_closer_look(&photo(1600), &[face(0.05)]));
        assert!(!worth_a_closer_look(&photo(1600), &[face(0.05), face(0.2)]));
        assert!(!worth_a_closer_look(&photo(300), &[]));
    }
}
