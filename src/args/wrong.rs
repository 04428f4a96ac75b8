//! A setting that does not do.

use crate::failure::{Class, Failure};
use crate::text::{Text, both};

/// Why this setting does not do.
pub(super) fn bad_setting(name: &str, why: Text) -> Failure {
    Failure::new(Class::Usage, format!("usage.{name}"), both!("{name}: {why}", "{name}: {why}", why))
}
