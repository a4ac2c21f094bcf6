//! Framing: which photo goes into which panel, and the crop that fits it.
//!
//! [`PhotoMeta`] is all that framing knows of a photo: measures, an energy map, and, once detection has run,
//! its subjects. [`assign()`] gives every panel a photo, [`frame()`] finds the crop. Both are pure functions;
//! pixels never come here, except once in [`EnergyMap::of`].

pub mod assign;
mod candidates;
pub mod energy;
mod frame;
mod photo;
mod score;
mod sums;

pub use assign::{Assignment, Order, Slot, assign, slots};
pub use energy::EnergyMap;
pub use frame::{Target, frame};
pub use photo::{Crop, FACE, Focus, PhotoMeta, Subject};
