//! What to say of work on several values or drives of which some failed.

use crate::failure::{Class, Failure};
use crate::text::both;

/// What to say when some of many questions failed: nothing, the failure itself, or that it is partly done.
pub fn summary(failures: Vec<Failure>, succeeded: usize) -> Option<Failure> {
    let count = failures.len();
    if let Some(end) = failures.iter().find(|failure| is_over(failure)) {
        return Some(end.clone());
    }
    let first = failures.into_iter().next()?;
    if succeeded == 0 {
        return Some(first);
    }
    let of = count + succeeded;
    let said = first.within(|why| {
        both!("{count} of {of} failed; the first: {why}", "{count} von {of} gescheitert; zuerst: {why}", why)
    });
    Some(Failure { class: Class::Partial, code: "partial".to_owned(), ..said })
}

/// Whether a failure ends the session: the port or the drive is gone, or somebody pressed Ctrl-C.
pub fn is_over(failure: &Failure) -> bool {
    failure.is_gone() || failure.class == Class::Interrupted
}
