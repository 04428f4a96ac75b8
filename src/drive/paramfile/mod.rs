//! A drive's settings as a file: what of it is read, reading it in few telegrams, comparing it.

mod asked;
mod compare;
mod harvest;
mod head;
mod in_force;

pub use asked::{Asking, Wanted, factory, held, of_file, of_set, reason};
pub use compare::{Compared, compare, unified};
pub use harvest::{Harvest, harvest};
pub use head::{Draft, broken, head, left_out, rows};
pub use in_force::{in_force, ram_sets};
