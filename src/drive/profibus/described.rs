//! A slave as its GSD describes it: what of that goes into Set_Prm for a mode.

use super::MOST_USER;
use super::mode::Mode;
use crate::failure::{Class, Failure};
use crate::files;
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::gsd::{Broken, Gsd, Module};
use crate::protocol::modbus::Hex;
use crate::text::{Text, both};
use std::path::Path;

/// Reads a GSD. Its letters are those of Windows or DOS; names are shown, and nothing else of them is used. A file that cannot be read or is
/// no GSD is `data.gsd`, with its line.
pub fn described(path: &Path) -> Result<Gsd, Failure> {
    let shown = path.display();
    let bad = |why: Text| Failure::new(Class::Data, "data.gsd", why);
    let bytes = files::read_bytes(path, files::TEXT).map_err(|error| bad(error.of(path)))?;
    let bytes = bytes.strip_prefix(&files::BYTE_ORDER_MARK).unwrap_or(&bytes);
    let text: String = bytes.iter().copied().map(char::from).collect();
    Gsd::parse(&text).map_err(|Broken { line, text }| match line {
        0 => bad(both!("{shown}: this is no GSD: {text} is missing", "{shown}: das ist keine GSD: {text} fehlt")),
        _ => bad(both!("{shown}:{line}: '{text}' makes no sense", "{shown}:{line}: '{text}' ergibt keinen Sinn")),
    })
}

/// User parameters of a mode by a GSD: those in front, and those of the module whose bytes are the configuration of the mode. Where several
/// have them, `series` is how the parameters of the right one end.
pub fn of_gsd(gsd: &Gsd, mode: Mode, series: Option<&[u8]>) -> Result<Vec<u8>, Failure> {
    let cfg = mode.layout();
    let fits: Vec<&Module> = gsd.modules.iter().filter(|module| module.cfg == cfg.bytes()).collect();
    let of_series = |module: &&&Module| series.is_none_or(|series| module.user.ends_with(series));
    let module = match fits[..] {
        [] if gsd.modules.is_empty() => return Ok(gsd.user.clone()),
        [only] => only,
        _ => {
            let mut meant = fits.iter().filter(of_series);
            meant.next().filter(|_| meant.next().is_none()).ok_or_else(|| none_fits(gsd, cfg))?
        }
    };
    let user = [&gsd.user[..], &module.user].concat();
    if user.len() > MOST_USER { Err(too_long(gsd, user.len())) } else { Ok(user) }
}

fn too_long(gsd: &Gsd, length: usize) -> Failure {
    let model = &gsd.model;
    let message = both!(
        "the GSD of '{model}' has {length} bytes of user parameters: Set_Prm takes {MOST_USER}",
        "die GSD von '{model}' hat {length} Bytes Anwenderparameter: Set_Prm fasst {MOST_USER}"
    );
    Failure::new(Class::Data, "data.gsd", message)
}

fn none_fits(gsd: &Gsd, cfg: Layout) -> Failure {
    let named = |module: &Module| format!("{} ({})", module.name, Hex(&module.cfg));
    let (model, has) = (&gsd.model, gsd.modules.iter().map(named).collect::<Vec<_>>().join(", "));
    let (cfg, name) = (Hex(cfg.bytes()), cfg.name());
    let message = both!(
        "the GSD of '{model}' has not exactly one module for {name} ({cfg}); it has: {has}",
        "die GSD von '{model}' hat nicht genau ein Modul für {name} ({cfg}); sie hat: {has}"
    );
    Failure::new(Class::Data, "data.gsd_module", message).hint(both!(
        "the GSD of the other mode? --mode, and --drive where it has a module for each series; or --user-prm with the bytes",
        "die GSD des anderen Modus? --mode, und --drive, wo sie für jede Serie ein Modul hat; oder --user-prm mit den Bytes"
    ))
}
