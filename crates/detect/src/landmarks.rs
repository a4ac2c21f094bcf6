//! Eyelids and lips of faces: `MediaPipe`'s face mesh of 468 points (Kartynnik et al., "Real-time Facial Surface
//! Geometry from Monocular Video on Mobile GPUs"). The model locates the parts of a face. It does not recognise people.

use super::faces::LABEL;
use super::model::Net;
use super::ssd::sigmoid;
use super::{Detection, Expression, FacePoints};
use inkpanel_image::error::{Error, Result};
use inkpanel_image::raster::Image;
use inkpanel_image::raster::resize::{Region, resample_image};

/// Side of the model's input in pixels.
const SIDE: usize = 192;
/// Number of points of a face.
const POINTS: usize = 468;
/// Side of the square that the model sees, in longer sides of the box of the face.
const MARGIN: f64 = 1.5;
/// Minimum probability that the square shows a face.
const PRESENT: f64 = 0.5;
/// Minimum longer side of a face, in pixels. Lids of smaller faces have too few pixels.
const MIN_SIDE: f64 = 64.0;
/// Maximum number of faces per photo. The largest ones count.
const MAX_FACES: usize = 6;

/// Places of the lids in the mesh: the corners of an eye, and its pairs of upper and lower lid.
const RIGHT_EYE: ([usize; 2], [[usize; 2]; 3]) = ([33, 133], [[160, 144], [159, 145], [158, 153]]);
const LEFT_EYE: ([usize; 2], [[usize; 2]; 3]) = ([263, 362], [[387, 373], [386, 374], [385, 380]]);
/// The middle of the upper and of the lower lip, where they meet.
const LIPS: [usize; 2] = [13, 14];
/// Corners of the opening of the mouth, and of the lips.
const OPENING: [usize; 2] = [78, 308];
const CORNERS: [usize; 2] = [61, 291];
/// The outer edges of the upper and of the lower lip, in the middle.
const EDGES: [usize; 2] = [0, 17];

/// The landmark model, loaded.
pub struct Landmarks {
    net: Net,
}

/// The surface of a face.
#[derive(Debug, Clone)]
pub struct FaceMesh {
    /// 468 points: right, down and depth in pixels of the photo. The depth grows away from the camera, and is 0 near the
    /// middle of the head.
    pub points: Vec<[f64; 3]>,
    /// Probability that there is a face, 0..1.
    pub presence: f64,
}

impl Landmarks {
    /// Loads the model (an ONNX file).
    ///
    /// # Errors
    /// `detector` if the file is not the expected model.
    pub fn new(onnx: &[u8]) -> Result<Self> {
        Ok(Self { net: Net::new(onnx, SIDE)? })
    }

    /// Finds the surface of a face.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn mesh(&self, photo: &Image, face: &Detection) -> Result<FaceMesh> {
        let square = Square::around(face, [photo.width(), photo.height()].map(|side| side as f64));
        let [points, logit] = self.net.run(&square.pixels(photo))?;
        let (points, rest) = points.as_chunks::<3>();
        if points.len() != POINTS || !rest.is_empty() || logit.len() != 1 {
            return Err(Error::Detector("the file is not the landmark model".into()));
        }
        let points = points.iter().map(|point| square.to_photo(point.map(f64::from))).collect();
        Ok(FaceMesh { points, presence: sigmoid(logit[0]) })
    }

    /// Adds the expressions of the largest faces, and moves their mouth to the middle of the lips. Faces below 64 pixels
    /// stay unchanged.
    ///
    /// # Errors
    /// `detector` if the model fails.
    pub fn read(&self, photo: &Image, found: &mut [Detection]) -> Result<()> {
        let sides = [photo.width() as f64, photo.height() as f64];
        for at in readable(sides, found) {
            let face = &mut found[at];
            let mesh = self.mesh(photo, face)?;
            if mesh.presence < PRESENT {
                continue;
            }
            face.expression = Some(mesh.expression());
            if let Some(points) = &mut face.points {
                let [x, y] = mesh.lips();
                points[3] = [(x / sides[0]).clamp(0.0, 1.0), (y / sides[1]).clamp(0.0, 1.0)];
            }
        }
        Ok(())
    }
}

/// Whether a photo has a face that is large enough for [`Landmarks::read`]. The size of the photo is in pixels.
#[must_use]
pub fn has_readable_faces(size: (usize, usize), found: &[Detection]) -> bool {
    !readable([size.0 as f64, size.1 as f64], found).is_empty()
}

/// Places of the faces that are large enough, the largest first.
fn readable(sides: [f64; 2], found: &[Detection]) -> Vec<usize> {
    let size = |at: usize| (found[at].width * sides[0]).max(found[at].height * sides[1]);
    let large = |at: &usize| found[*at].label == LABEL && size(*at) >= MIN_SIDE;
    let mut places: Vec<usize> = (0..found.len()).filter(large).collect();
    places.sort_by(|a, b| size(*b).total_cmp(&size(*a)));
    places.truncate(MAX_FACES);
    places
}

impl FaceMesh {
    /// Eyes and mouth of the face.
    #[must_use]
    pub fn expression(&self) -> Expression {
        let mouth = self.distance(LIPS) / self.distance(OPENING).max(1e-9);
        Expression {
            right_eye: rounded(self.openness(RIGHT_EYE)),
            left_eye: rounded(self.openness(LEFT_EYE)),
            mouth: rounded(mouth),
            smile: rounded(self.smile()),
        }
    }

    /// The middle of the lips, in pixels of the photo.
    #[must_use]
    pub fn lips(&self) -> [f64; 2] {
        let [[x, y, _], [other_x, other_y, _]] = LIPS.map(|at| self.points[at]);
        [f64::midpoint(x, other_x), f64::midpoint(y, other_y)]
    }

    /// Mean distance of the lids over the width of the eye.
    fn openness(&self, (corners, lids): ([usize; 2], [[usize; 2]; 3])) -> f64 {
        let sum: f64 = lids.iter().map(|pair| self.distance(*pair)).sum();
        sum / lids.len() as f64 / self.distance(corners).max(1e-9)
    }

    /// Height of the corners of the mouth above the middle of the lips' edges, over the width of the mouth.
    fn smile(&self) -> f64 {
        let middle = |[a, b]: [usize; 2]| -> [f64; 3] {
            std::array::from_fn(|axis| f64::midpoint(self.points[a][axis], self.points[b][axis]))
        };
        let (eyes, corners, edges) = (middle([33, 263]), middle(CORNERS), middle(EDGES));
        let minus = |a: [f64; 3], b: [f64; 3]| -> [f64; 3] { std::array::from_fn(|axis| a[axis] - b[axis]) };
        let dot = |a: [f64; 3], b: [f64; 3]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let (up, lift) = (minus(eyes, edges), minus(corners, edges));
        dot(lift, up) / dot(up, up).sqrt().max(1e-9) / self.distance(CORNERS).max(1e-9)
    }

    fn distance(&self, [a, b]: [usize; 2]) -> f64 {
        self.points[a].iter().zip(&self.points[b]).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    }
}

/// Short as text. The model is less precise.
fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

/// The part of a photo that the model sees: a square around a face, with level eyes. In pixels of the photo.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Square {
    centre: [f64; 2],
    side: f64,
    /// Cosine and sine of the angle of the eyes.
    turn: [f64; 2],
}

impl Square {
    fn around(face: &Detection, sides: [f64; 2]) -> Self {
        let centre = [(face.x + face.width / 2.0) * sides[0], (face.y + face.height / 2.0) * sides[1]];
        let side = MARGIN * (face.width * sides[0]).max(face.height * sides[1]);
        let angle = face.points.map_or(0.0, |[right, left, ..]: FacePoints| {
            ((left[1] - right[1]) * sides[1]).atan2((left[0] - right[0]) * sides[0])
        });
        Self { centre, side: side.max(1.0), turn: [angle.cos(), angle.sin()] }
    }

    /// A point of the model's input as a point of the photo.
    fn to_photo(self, [x, y, depth]: [f64; 3]) -> [f64; 3] {
        let pixel = self.side / SIDE as f64;
        let [across, down] = [x, y].map(|at| at * pixel - self.side / 2.0);
        let [cosine, sine] = self.turn;
        [
            self.centre[0] + cosine * across - sine * down,
            self.centre[1] + sine * across + cosine * down,
            depth * pixel,
        ]
    }

    /// Three planes of 192 x 192 values in 0..1. Outside the photo, the pixels of its edge are repeated.
    fn pixels(self, photo: &Image) -> Vec<f32> {
        let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]
            .map(|corner| self.to_photo([corner[0] * SIDE as f64, corner[1] * SIDE as f64, 0.0]));
        let span = |axis: usize, length: usize| {
            let all = corners.map(|corner| corner[axis]);
            let (low, high) = all.into_iter().fold((f64::MAX, f64::MIN), |(a, b), at| (a.min(at), b.max(at)));
            let from = (low - 1.0).floor().clamp(0.0, length as f64 - 1.0);
            (from, (high + 1.0).ceil().clamp(from + 1.0, length as f64) - from)
        };
        let ((x, width), (y, height)) = (span(0, photo.width()), span(1, photo.height()));
        // A large face is reduced first, so that every pixel of the photo counts.
        let shrunk = (self.side / SIDE as f64).max(1.0);
        let [across, down] = [width, height].map(|length| (length / shrunk).ceil().max(1.0));
        let part = resample_image(photo, Region { x, y, width, height }, across as usize, down as usize);
        let place = |at: f64, from: f64, length: f64, pixels: f64| {
            let at = ((at - from) / length * pixels - 0.5).clamp(0.0, pixels - 1.0);
            (at as usize, (at as usize + 1).min(pixels as usize - 1), at.fract() as f32)
        };
        let mut input = vec![0.0; 3 * SIDE * SIDE];
        let planes = part.planes();
        for row in 0..SIDE {
            for column in 0..SIDE {
                let [px, py, _] = self.to_photo([column as f64 + 0.5, row as f64 + 0.5, 0.0]);
                let (left, right, beside) = place(px, x, width, across);
                let (top, bottom, below) = place(py, y, height, down);
                for channel in 0..3 {
                    let plane = &planes[channel.min(planes.len() - 1)];
                    let mix = |y: usize| {
                        let (a, b) = (f32::from(plane.at(left, y)), f32::from(plane.at(right, y)));
                        a + (b - a) * beside
                    };
                    let (above, under) = (mix(top), mix(bottom));
                    input[(channel * SIDE + row) * SIDE + column] = (above + (under - above) * below) / 255.0;
                }
            }
        }
        input
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use inkpanel_image::raster::Plane;

    fn face(x: f64, y: f64, width: f64, eyes: [[f64; 2]; 2]) -> Detection {
        let points = [eyes[0], eyes[1], [x, y], [x, y], [x, y], [x, y]];
        Detection {
            label: LABEL.into(),
            score: 0.9,
            x,
            y,
            width,
            height: width,
            points: Some(points),
            expression: None,
            light: None,
        }
    }

    #[test]
    fn the_square_has_level_eyes_and_a_margin() {
        // In a photo of 400 x 200 pixels, the left eye is 40 pixels to the right and 40 pixels below.
        let face = Detection { height: 0.25, ..face(0.4, 0.4, 0.25, [[0.45, 0.4], [0.55, 0.6]]) };
        let square = Square::around(&face, [400.0, 200.0]);
        assert!((square.side - 150.0).abs() < 1e-9, "{square:?}");
        let [x, y, depth] = square.to_photo([96.0, 96.0, 19.2]);
        assert!((x - 210.0).abs() < 1e-9 && (y - 105.0).abs() < 1e-9 && (depth - 15.0).abs() < 1e-9);
        // The right edge of the square lies to the right and below.
        let [x, y, _] = square.to_photo([192.0, 96.0, 0.0]);
        let half = 75.0 / 2f64.sqrt();
        assert!((x - 210.0 - half).abs() < 1e-9 && (y - 105.0 - half).abs() < 1e-9, "{x} {y}");
    }

    #[test]
    fn the_square_is_cut_out_and_repeats_the_edge_of_the_photo() {
        let plane = Plane::from_fn(400, 200, |x, _| (x / 2) as u8);
        let photo = Image::from_rgb([plane.clone(), plane.clone(), plane]).unwrap();
        let upright = |x: f64| face(x, 0.3, 0.32, [[x, 0.5], [x + 0.2, 0.5]]);
        let pixels = Square::around(&upright(0.34), [400.0, 200.0]).pixels(&photo);
        let at = |pixels: &[f32], x: usize, y: usize| pixels[(SIDE + y) * SIDE + x] * 255.0;
        // The square is 192 pixels wide, from 104 to 296.
        for x in [0, 50, 191] {
            let expected = (104 + x) as f32 / 2.0;
            assert!((at(&pixels, x, 90) - expected).abs() < 1.0, "{} for {expected}", at(&pixels, x, 90));
        }
        let outside = Square::around(&upright(0.9), [400.0, 200.0]).pixels(&photo);
        assert!((at(&outside, 191, 5) - 199.0).abs() < 0.1, "{}", at(&outside, 191, 5));
        // A quarter turn: the photo's right is the square's bottom.
        let turned = face(0.34, 0.3, 0.32, [[0.5, 0.4], [0.5, 0.2]]);
        let turned = Square::around(&turned, [400.0, 200.0]).pixels(&photo);
        assert!((at(&turned, 10, 191) - (104 + 191) as f32 / 2.0).abs() < 1.0, "{}", at(&turned, 10, 191));
    }

    #[test]
    fn only_the_six_largest_faces_of_enough_pixels_are_read() {
        let eyes = [[0.1, 0.1], [0.2, 0.1]];
        let mut found: Vec<Detection> =
            (0..9).map(|i| face(0.1, 0.1, 0.05 + 0.01 * f64::from(i), eyes)).collect();
        found.push(Detection { label: "dog".into(), ..face(0.0, 0.0, 0.9, eyes) });
        assert_eq!(readable([1000.0, 600.0], &found), [8, 7, 6, 5, 4, 3]);
        assert_eq!(readable([600.0, 600.0], &found), [8, 7, 6]);
        assert!(!has_readable_faces((200, 300), &found));
    }

    #[test]
    fn expressions_are_ratios_of_distances() {
        let mut mesh = FaceMesh { points: vec![[0.0; 3]; POINTS], presence: 1.0 };
        let mut set = |at: usize, x: f64, y: f64| mesh.points[at] = [x, y, 0.0];
        for (([outer, inner], lids), x, open) in [(RIGHT_EYE, 0.0, 3.0), (LEFT_EYE, 60.0, 0.0)] {
            set(outer, x, 0.0);
            set(inner, x + 10.0, 0.0);
            for [upper, lower] in lids {
                set(upper, x + 5.0, -open / 2.0);
                set(lower, x + 5.0, open / 2.0);
            }
        }
        // The outer corner of the left eye is on the other side, at the same height.
        set(78, 10.0, 50.0);
        set(308, 30.0, 50.0);
        set(61, 5.0, 46.0);
        set(291, 35.0, 46.0);
        set(13, 20.0, 45.0);
        set(14, 20.0, 55.0);
        set(0, 30.0, 40.0);
        set(17, 30.0, 60.0);
        let expression = mesh.expression();
        let expected = Expression { right_eye: 0.3, left_eye: 0.0, mouth: 0.5, smile: 0.133 };
        assert!((expression.smile - expected.smile).abs() < 0.05, "{expression:?}");
        assert_eq!(Expression { smile: expected.smile, ..expression }, expected);
        assert_eq!(mesh.lips().map(f64::to_bits), [20.0, 50.0].map(f64::to_bits));
    }
}
