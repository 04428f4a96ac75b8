//! What to say of work on several values or drives of which some failed.

use crate::failure::{Class, Failure};
use crate::profile::Lang;

/// What to say when some of many questions failed: nothing, the failure itself, or that it is partly done.
pub fn summary(failures: Vec<Failure>, succeeded: usize, lang: Lang) -> Option<Failure> {
    let count = failures.len();
    if let Some(end) = failures.iter().find(|failure| is_over(failure)) {
        return Some(end.clone());
    }
    let first = failures.into_iter().next()?;
    if succeeded == 0 {
        return Some(first);
    }
    let message = match lang {
        Lang::En => format!("{count} of {} failed; the first: {}", count + succeeded, first.message.get(lang)),
        Lang::De => format!("{count} von {} gescheitert; zuerst: {}", count + succeeded, first.message.get(lang)),
    };
    let failure = Failure { class: Class::Partial, code: "partial".to_owned(), message: message.into(), ..first };
    Some(failure)
}

/// Whether a failure ends the session: the port is gone, or somebody pressed Ctrl-C.
pub fn is_over(failure: &Failure) -> bool {
    matches!(failure.class, Class::Port | Class::Interrupted)
}
