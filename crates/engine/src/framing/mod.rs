//! Framing: assigns photos to panels, and finds the crop for a panel.
//!
//! [`PhotoMeta`] is the input from a photo: measurements, an energy map and, after detection, its subjects.
//! [`crate::plan`] gives every panel a photo, [`frame()`] finds the crop. Both are pure functions. Pixels are
//! used only at import, in [`EnergyMap::of`], [`Facts::of`] and [`lettering()`].

mod bars;
mod candidates;
mod cropping;
pub mod energy;
mod facts;
mod frame;
mod lettering;
mod photo;
mod pixel;
pub mod region;
mod score;
mod sums;
mod target;

pub use energy::EnergyMap;
pub use facts::Facts;
pub use frame::{closeup, frame, sketch};
pub use inkpanel_model::crop::Crop;
pub use inkpanel_model::subject::{Expression, FACE, FIGURE, FacePoints, LETTERING, PERSON_HEAD, Subject};
pub use lettering::lettering;
#[cfg(feature = "detect")]
pub use photo::subject_of;
pub use photo::{Focus, PhotoMeta};
pub use region::Region;
pub(crate) use score::{MEDIUM, SURE};
pub use target::Target;
