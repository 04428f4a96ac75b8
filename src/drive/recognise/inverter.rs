//! The inverter behind an SJ2-PB says which series it is (P.624; SJ2-PB manual 5.3).

use super::{Finding, missing, said, told};
use crate::drive::profibus::{SERIES, series_named};
use crate::drive::{AccessError, Session};
use crate::exchange::Said;
use crate::exchange::dp::Request;
use crate::protocol::dp::pkw::Answer;
use crate::text::{Text, both};
use crate::tick::Tick;

/// Asks for it.
pub(super) async fn series(session: &mut Session<'_>, address: u8) -> Result<Finding, AccessError> {
    let mut finding = Finding::default();
    let asked = Text::name(format_args!("PKW P.{}", SERIES.pnu));
    let question = Request::read(SERIES, Tick::ZERO).asked();
    let answered = match said(session.ask(address, question).await)? {
        Ok(Said::Pkw(block)) if matches!(Answer::of(block.ak), Answer::Word | Answer::Double) => {
            finding.drive = series_named(block.pwe).map(str::to_owned);
            Text::name(format_args!("{:02X}h", block.pwe))
        }
        Ok(other) => crate::drive::route::no(&other).map_or_else(|| Text::name("-"), told),
        Err(error) => missing(&error),
    };
    let tells = match &finding.drive {
        Some(name) => both!("the series {name}", "die Serie {name}"),
        None => both!("no series that is known", "keine bekannte Serie"),
    };
    finding.note(asked, answered, tells);
    Ok(finding)
}
