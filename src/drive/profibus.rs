//! PROFIBUS without a controller: a line with us as its only master ([`Line`]), who is on it ([`live`]), parameters over PKW,
//! read and written ([`Exchange`]), and modules of an
//! SJ2-PB in Basic mode by name, from words to the bytes that a master sends, and back (manual 3.1.1, 3.1.2).

mod beside;
mod described;
mod ending;
mod exchange;
mod followed;
mod led;
mod line;
mod live;
mod looked;
mod mapped;
mod mode;
mod phrase;
mod read;
mod refusal;
mod run;
mod searched;
mod served;
mod showing;
mod shown;
mod state;
mod still;
mod told;
mod trouble;
mod watched;
mod words;
mod write;

pub use described::{described, of_gsd};
pub use ending::Ending;
pub use exchange::{Exchange, Taking, WATCHDOG};
pub use followed::follow;
pub use line::Line;
pub use live::{Round, configured, everybody, live, questions, slave_diag};
pub use looked::{LOOKED_AT, fault, leds};
pub use mapped::unmapped;
pub use mode::{Mode, Ramps, Seen, basic_block};
pub use read::{Haul, UNLOCKS};
pub(in crate::drive) use read::{SERIES, series_named};
pub(in crate::drive) use refusal::{no, refused};
pub use run::{Bounds, Lending, Rights, Run};
pub use searched::{RATES, found, search};
pub use state::of as state;
pub use trouble::motion::{coasting, off};
pub use trouble::{LOCKED, NOT_STILL, OTHER_SERIES};
pub use watched::by_words;
pub use words::{Course, Lead, Wanted, words};
pub(in crate::drive) use write::asking;
pub use write::{cyclic, planned};

use super::decode::hex_bytes;
use crate::failure::{Class, Failure};
use crate::outcome::BasicModule;
use crate::profile::{Family, Registry};
pub use crate::protocol::dp::gsd::Gsd;
use crate::protocol::dp::module::{Content, Module, Series};
use crate::text::{Text, both};
use std::rc::Rc;

/// Reads a module as words, such as `L200 set deceleration`, or as its bytes, and tells both.
pub fn module(text: &str, named: Option<&Family>, registry: &Registry) -> Result<BasicModule, Failure> {
    // No word of a phrase is made of pairs of hexadecimal digits alone.
    let typed = hex_bytes(text).ok();
    let (module, family) = match typed {
        Some(bytes) => {
            let module = Module::decode(&bytes).map_err(|error| usage(told::wrong(&error)))?;
            let family = inverter(module.series, registry)?;
            (module, family)
        }
        None => phrase::read(text, named, registry)?,
    };
    told::told(text, &module, &family)
}

/// Bytes of user parameters as they are typed; `None` if they are none, or more than Set_Prm takes.
pub fn user_parameters(text: &str) -> Option<Vec<u8>> {
    hex_bytes(text).ok().filter(|bytes| bytes.len() <= MOST_USER)
}

/// User parameters of one Set_Prm (IEC 61158-6-3).
const MOST_USER: usize = 237;

/// The catalogue of a series.
fn inverter(series: Series, registry: &Registry) -> Result<Rc<Family>, Failure> {
    registry.family(word(series)).ok_or_else(|| {
        let drive = word(series);
        usage(both!("there is no catalogue of '{drive}'", "es gibt keinen Katalog von '{drive}'"))
    })
}

/// The word of a series: that of `--drive`.
fn word(series: Series) -> &'static str {
    match series {
        Series::L200 => "l200",
        Series::Sj200 => "sj200",
        Series::X200 => "x200",
    }
}

/// Whether a module goes to the inverter.
fn is_output(module: &Module) -> bool {
    matches!(module.content, Content::Parameter { is_output: true, .. })
}

fn usage(why: Text) -> Failure {
    Failure::new(Class::Usage, "usage.module", why)
}
