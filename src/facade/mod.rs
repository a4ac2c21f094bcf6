//! Public API for other crates: photos, albums, pages and styles. The types have no public fields. No
//! algorithm is here.

mod album;
mod failure;
#[cfg(feature = "detect")]
mod nets;
mod note;
mod options;
mod page;
mod photo;
mod pixels;
mod places;
mod style;

pub use album::Album;
#[cfg(feature = "internals")]
pub use album::{BookPlan, Selection};
pub use failure::Failure;
#[cfg(feature = "internals")]
pub use failure::survived;
#[cfg(feature = "detect")]
pub use nets::Nets;
pub use note::Note;
pub use options::{BookOptions, PageOptions, layouts};
#[cfg(feature = "internals")]
pub use page::with_names;
pub use page::{Page, pdf};
pub use photo::Photo;
pub use pixels::Pixels;
pub use places::PlaceNames;
pub use style::Style;
