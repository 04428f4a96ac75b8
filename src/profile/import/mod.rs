//! Lists of parameters that others wrote, as rows of a catalogue: a spreadsheet of a site or a supplier (`table`), and maps of
//! registers in the public MBMap format (`mbmap`). Text in, rows out; nothing here opens a file.
//!
//! What a list does not say stays open, what can be taken in two ways is refused with the option that decides, and what this
//! program cannot show as it is (floats, other scales than powers of ten) is left out with its line and why.

mod cells;
mod draft;
mod export;
mod heading;
mod mbmap;
mod sheet;
mod table;
mod write;

pub use draft::{ColumnTaken, Draft, ImportError, Imported, LeftOut, Own, Wishes};
pub use export::{COLUMNS, cells_of};
pub use mbmap::mbmap;
pub use table::table;
pub use write::{Target, Written, write};
