//! A setting that does not do.

use crate::failure::{Class, Failure};

/// Why this setting does not do.
pub(super) fn bad_setting(name: &str, why: &str) -> Failure {
    Failure::new(Class::Usage, format!("usage.{name}"), format!("{name}: {why}"))
}
