//! What was typed names no parameter.

use crate::failure::{Class, Failure};
use crate::profile::{LookupError, SelectError};
use crate::text::{Text, both};

/// Why it names none, and what to do.
pub(super) fn select_failure(error: &SelectError) -> Failure {
    let failure = |class, code: &str| Failure::new(class, code, error.text());
    match error {
        SelectError::Lookup(LookupError::Unknown { near, .. }) => {
            let hint = if near.is_empty() {
                both!(
                    "`antrieb params WORD` searches the catalogue; a number always works",
                    "`antrieb params WORT` sucht im Katalog; eine Nummer geht immer"
                )
            } else {
                both!("did you mean {near}?", "gemeint ist vielleicht {near}", near = Text::join(near, ", "))
            };
            failure(Class::Data, "data.unknown_parameter").hint(hint)
        }
        SelectError::Lookup(LookupError::Ambiguous { .. }) => failure(Class::Data, "data.ambiguous_parameter")
            .hint(both!("use the number or the slug", "die Nummer oder die Kennung angeben")),
        SelectError::Group { .. } => failure(Class::Data, "data.unknown_group"),
        _ => failure(Class::Usage, "usage.parameter"),
    }
}
