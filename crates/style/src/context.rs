//! State that a run passes to its blocks: scale, scratch memory, cancellation.

use super::face_box::FaceBox;
use super::painters::{Norms, Painters};
use super::point_op::PointOp;
use crate::error::{Error, Result};
use crate::raster::{Image, Plane};
use crate::simd::gaussian::Buffers;
use std::any::Any;
use std::sync::Arc;

/// Number of pixels of the image for which spatial parameters are defined.
const REFERENCE_PIXELS: f64 = 1920.0 * 1080.0;

/// Scale and scratch memory of a render, and a function for cancelling it. The memory is reused, so that
/// moving a slider allocates nothing.
#[derive(Default)]
pub struct Context<'a> {
    scale: f32,
    /// Buffers of the blurs.
    pub blurs: Buffers,
    /// Floats of the iterative blocks.
    pub floats: Vec<Vec<f32>>,
    /// Memory of single blocks: at most one value of a type.
    scratch: Vec<Box<dyn Any>>,
    faces: Vec<FaceBox>,
    subject: Option<Plane>,
    painters: Option<Arc<Painters>>,
    /// Models of the user, by the hash in their references.
    own_painters: Vec<(String, Arc<Painters>)>,
    steady: Steady,
    tones: KnownTones,
    planes: Vec<Vec<u8>>,
    cancelled: Option<&'a dyn Fn() -> bool>,
}

/// Measurement of a block in a whole picture.
#[allow(clippy::large_enum_variant, reason = "a style has few of them")]
pub(crate) enum Measured {
    /// The operation of a block that looks at tones.
    Tones(PointOp),
    /// The statistics of a painter, and its painting if it was recorded.
    Painting(Arc<Norms>, Option<Image>),
}

impl Measured {
    /// The measurement for a part of the picture. `cut` returns the part of a painting, or `None` if the part is painted
    /// again.
    pub(crate) fn of_part(&self, cut: impl FnOnce(&Image) -> Option<Image>) -> Self {
        match self {
            Self::Tones(op) => Self::Tones(op.clone()),
            Self::Painting(norms, painting) => Self::Painting(norms.clone(), painting.as_ref().and_then(cut)),
        }
    }
}

/// Measurements of blocks, in order. Parts of a picture use the measurements of the whole picture.
#[derive(Default)]
enum KnownTones {
    /// Blocks measure each picture.
    #[default]
    None,
    /// The measurements so far, and whether paintings are recorded.
    Recorded(Vec<Measured>, bool),
    /// The next measurements.
    Replayed(std::vec::IntoIter<Measured>),
}

/// Statistics of painters in the first frame of an animated panel. Later frames use them, so that colours do not
/// flicker.
#[derive(Default)]
enum Steady {
    /// Each picture is separate.
    #[default]
    Off,
    /// The statistics of the first frame so far.
    First(Vec<Arc<Norms>>),
    /// The statistics of the first frame, and how many of them this frame used.
    Later(Vec<Arc<Norms>>, usize),
}

impl<'a> Context<'a> {
    /// Returns a context for a stand-alone image. The scale follows its size.
    #[must_use]
    pub fn for_image(image: &Image) -> Self {
        let mut context = Self::default();
        context.fit_scale(image);
        context
    }

    /// Sets the scale for an image that is rendered separately.
    pub fn fit_scale(&mut self, image: &Image) {
        self.scale = scale_of(image.width() as f64 * image.height() as f64);
    }

    /// Sets the scale: pixels of this render for one pixel of a 1920 x 1080 image.
    pub fn set_scale(&mut self, scale: f32) {
        self.scale = scale;
    }

    /// Pixels of this render for one pixel of a 1920 x 1080 image.
    #[must_use]
    pub fn scale(&self) -> f32 {
        self.scale
    }

    /// Tells the faces of the image that is stylised next, in its pixels.
    pub fn show_faces(&mut self, faces: Vec<FaceBox>) {
        self.faces = faces;
    }

    /// Takes the faces of this image, so that the next image starts without faces. Returns an empty list if
    /// the style does not protect faces.
    pub(crate) fn shown_faces(&mut self, cared: bool) -> Vec<FaceBox> {
        let faces = std::mem::take(&mut self.faces);
        if cared { faces } else { Vec::new() }
    }

    /// Sets the subject mask of the next image, at its size: 255 inside, 0 outside. `None` if the subject is
    /// unknown.
    pub fn show_subject(&mut self, subject: Option<Plane>) {
        self.subject = subject;
    }

    /// Returns the subject mask of this image, if it is known.
    pub(crate) fn subject(&self) -> Option<&Plane> {
        self.subject.as_ref()
    }

    /// Records the measurements of blocks in the next picture. `paintings`: also records paintings.
    pub(crate) fn record_tones(&mut self, paintings: bool) {
        self.tones = KnownTones::Recorded(Vec::new(), paintings);
    }

    /// Ends recording and replaying, and returns the recorded operations.
    pub(crate) fn recorded_tones(&mut self) -> Vec<Measured> {
        match std::mem::take(&mut self.tones) {
            KnownTones::Recorded(ops, _) => ops,
            _ => Vec::new(),
        }
    }

    /// Uses recorded operations for the next picture, which is a part of the recorded one.
    pub(crate) fn replay_tones(&mut self, ops: Vec<Measured>) {
        self.tones = KnownTones::Replayed(ops.into_iter());
    }

    /// Returns the next replayed operation, or calls `make`.
    pub(crate) fn tones_or(&mut self, make: impl FnOnce(&mut Self) -> PointOp) -> PointOp {
        if let KnownTones::Replayed(ops) = &mut self.tones
            && let Some(Measured::Tones(op)) = ops.next()
        {
            return op;
        }
        let op = make(self);
        if let KnownTones::Recorded(ops, _) = &mut self.tones {
            ops.push(Measured::Tones(op.clone()));
        }
        op
    }

    /// Sets the model of the block Painter.
    pub fn show_painters(&mut self, painters: Option<Arc<Painters>>) {
        self.painters = painters;
    }

    /// Whether there is a model of the block Painter.
    #[must_use]
    pub fn has_painters(&self) -> bool {
        self.painters.is_some()
    }

    /// Adds a model of the user. `hash` is the part of its references in styles.
    pub fn show_own_painters(&mut self, hash: &str, painters: Arc<Painters>) {
        self.own_painters.retain(|(known, _)| known != hash);
        self.own_painters.push((hash.to_owned(), painters));
    }

    /// Removes the models of the user.
    pub fn hide_own_painters(&mut self) {
        self.own_painters.clear();
    }

    /// Returns the model of the block Painter, if there is one. An unknown model of a user is replaced by the built-in
    /// one, so that a style without its model can be drawn.
    pub(crate) fn painters(&self, reference: Option<&str>) -> Option<Arc<Painters>> {
        let hash = reference.and_then(|reference| reference.split(' ').next());
        let own = self.own_painters.iter().find(|(known, _)| Some(known.as_str()) == hash);
        own.map(|(_, painters)| painters.clone()).or_else(|| self.painters.clone())
    }

    /// Starts a series of frames. Painters measure only the first frame.
    pub fn begin_frames(&mut self) {
        self.steady = Steady::First(Vec::new());
    }

    /// Starts the next frame of a series.
    pub fn next_frame(&mut self) {
        self.steady = match std::mem::take(&mut self.steady) {
            Steady::First(norms) | Steady::Later(norms, _) => Steady::Later(norms, 0),
            Steady::Off => Steady::Off,
        };
    }

    /// Ends a series of frames.
    pub fn end_frames(&mut self) {
        self.steady = Steady::Off;
    }

    /// Returns the statistics of the next painter, if this picture is a part or a later frame of a measured one, and its
    /// painting if it was recorded.
    pub(crate) fn known_painting(&mut self) -> Option<(Arc<Norms>, Option<Image>)> {
        if let KnownTones::Replayed(ops) = &mut self.tones {
            return match ops.next() {
                Some(Measured::Painting(norms, painting)) => Some((norms, painting)),
                _ => None,
            };
        }
        let Steady::Later(all, used) = &mut self.steady else { return None };
        let norms = all.get(*used).cloned()?;
        *used += 1;
        Some((norms, None))
    }

    /// Stores the statistics of a painter and its painting. A part of a measured picture stores nothing.
    pub(crate) fn note_painting(&mut self, norms: Arc<Norms>, painting: &Image) {
        match &mut self.tones {
            KnownTones::Recorded(ops, paintings) => {
                ops.push(Measured::Painting(norms.clone(), paintings.then(|| painting.clone())));
            }
            KnownTones::Replayed(_) => return,
            KnownTones::None => {}
        }
        if let Steady::First(all) = &mut self.steady {
            all.push(norms);
        }
    }

    /// Asks `cancelled` between blocks.
    pub fn stop_when(&mut self, cancelled: &'a dyn Fn() -> bool) {
        self.cancelled = Some(cancelled);
    }

    /// # Errors
    /// `cancelled` if the caller cancels.
    pub fn check_cancelled(&self) -> Result<()> {
        if self.cancelled.is_some_and(|cancelled| cancelled()) { Err(Error::Cancelled) } else { Ok(()) }
    }

    /// Takes the value of this type that a block stored with [`Self::give`], so that it can use the memory or a drawing of an
    /// earlier run. `None` on the first run.
    pub fn take<T: 'static>(&mut self) -> Option<T> {
        let at = self.scratch.iter().position(|value| value.is::<T>())?;
        self.scratch.swap_remove(at).downcast().ok().map(|value| *value)
    }

    /// Stores a value of a block for its next run. It replaces the value of the same type.
    pub fn give<T: 'static>(&mut self, value: T) {
        drop(self.take::<T>());
        self.scratch.push(Box::new(value));
    }

    /// A plane with arbitrary content.
    pub fn take_plane(&mut self, width: usize, height: usize) -> Plane {
        let mut samples = self.planes.pop().unwrap_or_default();
        samples.resize(width.max(1) * height.max(1), 0);
        Plane::from_samples(width.max(1), height.max(1), samples)
            .unwrap_or_else(|_| Plane::filled(width, height, 0))
    }

    /// Takes a plane back for reuse.
    pub fn give_plane(&mut self, plane: Plane) {
        // A handful covers any chain; more would only hold memory.
        if self.planes.len() < 8 {
            self.planes.push(plane.into_samples());
        }
    }

    /// A copy of a plane in reused memory.
    pub fn copy_plane(&mut self, plane: &Plane) -> Plane {
        let mut copy = self.take_plane(plane.width(), plane.height());
        copy.samples_mut().copy_from_slice(plane.samples());
        copy
    }

    /// A buffer of floats with arbitrary content.
    pub fn take_floats(&mut self, count: usize) -> Vec<f32> {
        let mut floats = self.floats.pop().unwrap_or_default();
        floats.resize(count, 0.0);
        floats
    }

    /// Takes floats back for reuse.
    pub fn give_floats(&mut self, floats: Vec<f32>) {
        if self.floats.len() < 8 {
            self.floats.push(floats);
        }
    }
}

/// Returns the scale of an image of `pixels` pixels: sqrt(pixels / (1920 * 1080)).
#[must_use]
pub fn scale_of(pixels: f64) -> f32 {
    (pixels / REFERENCE_PIXELS).sqrt() as f32
}
