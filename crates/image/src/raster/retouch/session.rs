//! A mask during correction: the steps and their undo.

use super::{Brush, Figures, WITHIN, feathered, grown, inverted, joined, shrunk};
use crate::raster::matte::{LEAST_CONFIDENCE, MOST_TEXT};
use crate::raster::resize::fit;
use crate::raster::{Matte, Plane, matte};

/// Distance of growing and shrinking, and width of feathering, in photo widths.
const STEP: f32 = 0.008;
/// A figure of less than this part of the photo is passed over by [`Mending::NextFigure`].
const LEAST_FIGURE: f64 = 0.001;
/// Steps that can be undone.
const MOST_STEPS: usize = 200;
/// Rounding steps of mask values. Coarser ones are tried until the text is short enough.
const ROUNDINGS: [u8; 4] = [1, 51, 85, 255];

/// A correction of the whole mask.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mending {
    /// Grows the mask.
    Grow,
    /// Shrinks the mask.
    Shrink,
    /// Softens the border, while the mask has a visible border.
    Feather,
    /// Inverts the mask.
    Invert,
    /// The subject is everything that was found, or the whole photo if nothing was found.
    Everything,
    /// Empties the mask.
    Nothing,
    /// The detected mask, without corrections.
    Found,
    /// Only the next of several figures.
    NextFigure,
    /// Only the figure at a point, in fractions of the photo.
    FigureAt([f32; 2]),
}

/// A state of the mask.
#[derive(Clone, PartialEq)]
struct State {
    mask: Matte,
    /// The subject before one of several figures was selected.
    others: Matte,
    /// Whether a hand corrected it.
    own: bool,
}

/// A mask that is corrected.
pub struct Session {
    found: Option<Plane>,
    states: Vec<State>,
    at: usize,
    /// The mask with the stroke that is not ended yet, if there is one.
    mask: Plane,
}

impl Session {
    /// Begins with the corrected mask of a photo, the detected mask, or an empty mask, in this order. `size`
    /// is the size of the photo or of a smaller copy.
    #[must_use]
    pub fn new(size: (usize, usize), own: Option<&Matte>, found: Option<&Matte>) -> Self {
        let (width, height) = fit(size.0.max(1), size.1.max(1), matte::LONGEST);
        let empty = Plane::filled(width, height, 0);
        let plane = |mask: &Matte| Matte::new(&mask.plane(), (width, height)).plane();
        let found = found.map(plane);
        let mask = own.map(plane).or_else(|| found.clone()).unwrap_or_else(|| empty.clone());
        let others = found.as_ref().map_or(empty, |found| apart(found, &mask));
        let kept = |plane: &Plane| Matte::new(plane, (width, height));
        let states = vec![State { mask: kept(&mask), others: kept(&others), own: own.is_some() }];
        Self { found, states, at: 0, mask }
    }

    /// The current mask.
    #[must_use]
    pub fn mask(&self) -> &Plane {
        &self.mask
    }

    /// The part of the photo that is its subject, 0 to 1.
    #[must_use]
    pub fn coverage(&self) -> f64 {
        let sum: u64 = self.mask.samples().iter().map(|share| u64::from(*share)).sum();
        sum as f64 / (255 * self.mask.samples().len()) as f64
    }

    /// Whether undo and redo are possible.
    #[must_use]
    pub fn can(&self) -> (bool, bool) {
        (self.at > 0, self.at + 1 < self.states.len())
    }

    /// Whether the mask is the detected mask, without corrections.
    #[must_use]
    pub fn is_found(&self) -> bool {
        !self.states[self.at].own
    }

    /// The masks after each step up to the current one. `None` means the detected mask.
    #[must_use]
    pub fn steps(&self) -> Vec<Option<&Matte>> {
        self.states[1..=self.at].iter().map(|state| state.own.then_some(&state.mask)).collect()
    }

    /// Paints on: places in parts of the photo, the radius in photo widths. [`Self::end`] makes it an undo
    /// step.
    pub fn paint(&mut self, path: &[[f32; 2]], radius: f32, adds: bool) {
        let (width, height) = (self.mask.width() as f32, self.mask.height() as f32);
        let path: Vec<[f32; 2]> = path.iter().map(|[x, y]| [x * width, y * height]).collect();
        Brush { radius: radius * width, adds }.paint(&mut self.mask, &path);
    }

    /// Ends a stroke, as one undo step.
    ///
    /// Returns whether anything changed.
    pub fn end(&mut self) -> bool {
        let others = self.states[self.at].others.clone();
        self.step(&self.mask.clone(), others, true)
    }

    /// Discards the current stroke.
    pub fn abandon(&mut self) {
        self.mask = self.states[self.at].mask.plane();
    }

    /// Applies a correction to the whole mask, as one undo step.
    ///
    /// Returns whether anything changed.
    pub fn mend(&mut self, mending: Mending) -> bool {
        self.abandon();
        let others = self.states[self.at].others.clone();
        let reach = (STEP * self.mask.width() as f32).max(1.0);
        let filled = |share| Plane::filled(self.mask.width(), self.mask.height(), share);
        let mask = match mending {
            Mending::Grow => grown(&self.mask, reach),
            Mending::Shrink => shrunk(&self.mask, reach),
            Mending::Feather => {
                let softer = feathered(&self.mask, reach as usize);
                // A mask with an uncertain border would be unusable.
                if kept(&softer).is_none_or(|matte| matte.facts().confidence < LEAST_CONFIDENCE) {
                    return false;
                }
                softer
            }
            Mending::Invert => inverted(&self.mask),
            Mending::Everything => self.found.clone().unwrap_or_else(|| filled(255)),
            Mending::Nothing => filled(0),
            Mending::Found => {
                let found = self.found.clone().unwrap_or_else(|| filled(0));
                return self.step(&found, others, false);
            }
            Mending::NextFigure | Mending::FigureAt(_) => {
                let Some((one, rest)) = self.chosen(mending) else { return false };
                let others = Matte::new(&rest, (rest.width(), rest.height()));
                return self.step(&one, others, true);
            }
        };
        self.step(&mask, others, true)
    }

    /// One step back. Returns whether there was one.
    pub fn undo(&mut self) -> bool {
        let before = self.at.checked_sub(1);
        before.is_some_and(|at| self.go(at))
    }

    /// Redoes one step. Returns whether there was one.
    pub fn redo(&mut self) -> bool {
        self.at + 1 < self.states.len() && self.go(self.at + 1)
    }

    fn go(&mut self, at: usize) -> bool {
        self.at = at;
        self.abandon();
        true
    }

    /// The figure that is chosen, and all others. Figures outside of the current subject can be selected as
    /// well.
    fn chosen(&self, mending: Mending) -> Option<(Plane, Plane)> {
        let all = joined(&self.mask, &self.states[self.at].others.plane());
        let figures = Figures::of(&all);
        let number = match mending {
            Mending::FigureAt([x, y]) => {
                let place = |part: f32, length: usize| (part.max(0.0) * length as f32) as usize;
                let (x, y) = (place(x, all.width()), place(y, all.height()));
                figures.at(y.min(all.height() - 1) * all.width() + x.min(all.width() - 1))?
            }
            _ => self.next(&figures)?,
        };
        Some((figures.only(&all, |other| other == number), figures.only(&all, |other| other != number)))
    }

    /// The largest figure if several are the subject, or the next smaller one. `None` with only one figure.
    fn next(&self, figures: &Figures) -> Option<usize> {
        let least = (LEAST_FIGURE * self.mask.samples().len() as f64) as usize;
        let count = figures.areas().iter().filter(|area| **area >= least).count();
        let mut seen = vec![false; figures.areas().len()];
        let within = self.mask.samples().iter().enumerate().filter(|(_, share)| **share >= WITHIN);
        within.filter_map(|(at, _)| figures.at(at)).for_each(|number| seen[number] = true);
        let mut shown = (0..count).filter(|number| seen[*number]);
        match (shown.next(), shown.next()) {
            (Some(one), None) => (count > 1).then_some((one + 1) % count),
            _ => (count > 0).then_some(0),
        }
    }

    /// Adds a mask as the next step, unless nothing changed. This clears redo.
    fn step(&mut self, mask: &Plane, others: Matte, own: bool) -> bool {
        let Some(mask) = kept(mask) else {
            self.abandon();
            return false;
        };
        let state = State { mask, others, own };
        let now = &self.states[self.at];
        if (now.mask == state.mask) && (now.own == state.own || own) {
            self.abandon();
            return false;
        }
        self.states.truncate(self.at + 1);
        self.states.push(state);
        if self.states.len() > MOST_STEPS + 1 {
            self.states.remove(1);
        }
        self.at = self.states.len() - 1;
        self.abandon();
        true
    }
}

/// The figures of a mask that have nothing in common with another.
fn apart(mask: &Plane, other: &Plane) -> Plane {
    let figures = Figures::of(mask);
    let mut met = vec![false; figures.areas().len()];
    let within = other.samples().iter().enumerate().filter(|(_, share)| **share >= WITHIN);
    within.filter_map(|(at, _)| figures.at(at)).for_each(|number| met[number] = true);
    figures.only(mask, |number| !met[number])
}

/// The mask in storage form, with fewer levels if its text would be too long. `None` if no number of levels
/// is small enough.
fn kept(mask: &Plane) -> Option<Matte> {
    ROUNDINGS.into_iter().find_map(|to| {
        let mut rounded = mask.clone();
        let half = to / 2;
        rounded.samples_mut().iter_mut().for_each(|share| *share = share.saturating_add(half) / to * to);
        let matte = Matte::new(&rounded, (mask.width(), mask.height()));
        (matte.text().len() <= MOST_TEXT).then_some(matte)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: (usize, usize) = (320, 200);

    /// Squares of 40 pixels at these places.
    fn squares(places: &[(usize, usize)]) -> Matte {
        let inside = |x: usize, y: usize| {
            places.iter().any(|(left, top)| (*left..left + 40).contains(&x) && (*top..top + 40).contains(&y))
        };
        Matte::new(&Plane::from_fn(SIZE.0, SIZE.1, |x, y| 255 * u8::from(inside(x, y))), SIZE)
    }

    fn begun(found: Option<&Matte>) -> Session {
        Session::new((1600, 1000), None, found)
    }

    #[test]
    fn each_stroke_and_command_is_a_step_that_is_undone_and_done_again() {
        let mut session = begun(None);
        assert_eq!((session.coverage(), session.can(), session.steps().len()), (0.0, (false, false), 0));
        session.paint(&[[0.2, 0.5]], 0.05, true);
        session.paint(&[[0.2, 0.5], [0.8, 0.5]], 0.05, true);
        assert!(session.end());
        let (stroke, covered) = (session.mask().clone(), session.coverage());
        assert!(session.mend(Mending::Grow));
        let grown = session.mask().clone();
        assert!(covered > 0.07 && session.coverage() > 1.1 * covered);
        assert_eq!((session.steps().len(), session.can()), (2, (true, false)));
        assert!(session.undo());
        assert_eq!((session.mask(), session.can()), (&stroke, (true, true)));
        assert!(session.redo() && !session.redo());
        assert_eq!(session.mask(), &grown);
        assert!(session.undo() && session.undo() && !session.undo());
        assert_eq!((session.coverage(), session.can()), (0.0, (false, true)));
        // The next step clears redo.
        session.paint(&[[0.5, 0.5]], 0.1, true);
        assert!(session.end() && !session.redo());
        // Emptying an empty mask is not a step.
        assert!(session.mend(Mending::Nothing) && !session.mend(Mending::Nothing));
    }

    #[test]
    fn a_stroke_that_is_taken_back_was_none() {
        let found = squares(&[(20, 20)]);
        let mut session = begun(Some(&found));
        session.paint(&[[0.9, 0.9]], 0.1, true);
        session.abandon();
        assert!(!session.end());
        assert_eq!((session.mask(), session.can()), (&found.plane(), (false, false)));
    }

    #[test]
    fn what_is_kept_is_what_is_seen_and_can_be_read() {
        let mut session = begun(Some(&squares(&[(20, 20), (200, 100)])));
        for mending in [Mending::Feather, Mending::Shrink, Mending::Invert, Mending::Feather] {
            assert!(session.mend(mending));
            let text = session.steps().last().unwrap().unwrap().text().to_owned();
            assert_eq!(&Matte::try_from(text).unwrap().plane(), session.mask());
        }
        // Noise has no runs: it is stored with fewer levels, or nothing changes.
        let mut seed = 7u32;
        let noise = Plane::from_fn(320, 320, |_, _| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (seed >> 24) as u8
        });
        assert!(kept(&noise).is_none_or(|matte| matte.text().len() <= MOST_TEXT));
        let soft = feathered(&noise, 2);
        let soft = kept(&soft).unwrap();
        assert!(soft.text().len() <= MOST_TEXT && Matte::try_from(soft.text().to_owned()).is_ok());
    }

    #[test]
    fn figures_are_chosen_one_after_the_other_and_at_a_point() {
        let found = squares(&[(20, 20), (140, 100), (260, 20)]);
        let mut session = begun(Some(&found));
        let there =
            |session: &Session| [(40, 40), (160, 120), (280, 40)].map(|(x, y)| session.mask().at(x, y) > 0);
        assert!(session.mend(Mending::NextFigure));
        assert_eq!(there(&session), [true, false, false]);
        assert!(session.mend(Mending::NextFigure));
        assert_eq!(there(&session), [false, false, true]);
        assert!(session.mend(Mending::NextFigure) && session.mend(Mending::NextFigure));
        assert_eq!(there(&session), [true, false, false]);
        assert!(session.mend(Mending::FigureAt([0.5, 0.6])));
        assert_eq!(there(&session), [false, true, false]);
        assert!(!session.mend(Mending::FigureAt([0.02, 0.98])));
        // A painted area is a figure as well, and the detected figures return.
        session.paint(&[[0.1, 0.85]], 0.05, true);
        assert!(session.end() && session.mend(Mending::FigureAt([0.1, 0.85])));
        assert_eq!(there(&session), [false; 3]);
        assert!(session.mend(Mending::FigureAt([0.87, 0.2])));
        assert_eq!(there(&session), [false, false, true]);
        // In a new session, other figures can be selected as well.
        let own = squares(&[(20, 20)]);
        let mut later = Session::new(SIZE, Some(&own), Some(&found));
        assert!(later.mend(Mending::NextFigure) && there(&later) == [false, false, true]);
        // A single figure offers no choice.
        assert!(!begun(Some(&own)).mend(Mending::NextFigure) && !begun(None).mend(Mending::NextFigure));
    }

    #[test]
    fn what_was_found_comes_back_and_is_nobodys() {
        let found = squares(&[(20, 20)]);
        let mut session = Session::new(SIZE, Some(&squares(&[(200, 100)])), Some(&found));
        assert!(!session.is_found() && session.mend(Mending::Found) && session.is_found());
        assert_eq!((session.mask(), session.steps()), (&found.plane(), vec![None]));
        assert!(!session.mend(Mending::Found));
        assert!(session.mend(Mending::Grow) && session.mend(Mending::Everything));
        assert_eq!((session.mask(), session.is_found()), (&found.plane(), false));
        // Without anything that was found, everything is all of the photo.
        let mut none = begun(None);
        assert!(none.mend(Mending::Everything));
        assert_eq!((none.coverage(), none.steps().len()), (1.0, 1));
    }

    #[test]
    fn whatever_brush_and_however_often_softened_the_mask_is_not_vague() {
        for radius in [0.005, 0.04, 0.2] {
            let mut session = begun(None);
            session.paint(&[[0.3, 0.3], [0.7, 0.6]], radius, true);
            assert!(session.end());
            let facts = |session: &Session| session.steps().last().unwrap().unwrap().facts();
            assert!(facts(&session).confidence > 0.7, "{radius}: {:?}", facts(&session));
            let softened = (0..30).take_while(|_| session.mend(Mending::Feather)).count();
            assert!(softened < 30, "{radius}");
            assert!(facts(&session).confidence >= LEAST_CONFIDENCE, "{radius}: {:?}", facts(&session));
        }
    }

    #[test]
    fn the_first_of_many_steps_go_and_what_is_kept_stays() {
        let mut session = begun(None);
        for i in 0..MOST_STEPS + 20 {
            assert!(session.mend(if i % 2 == 0 { Mending::Everything } else { Mending::Nothing }));
        }
        assert_eq!((session.steps().len(), session.coverage()), (MOST_STEPS, 0.0));
    }
}
