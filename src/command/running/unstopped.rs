//! What is said where a stop is not proven, or could not go out at all.

use crate::drive::motion::{Situation, has_power};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::text::{Text, both};

/// The failure of a stop for which no port could be opened: nothing went out.
pub(in crate::command) fn unsent(failure: Failure) -> Failure {
    if failure.class != Class::Port {
        return failure;
    }
    let hint = match failure.code.as_str() {
        "port.busy" => both!(
            "Ctrl-C in the program that holds the port ends a run of antrieb by its stop; or the enable input, the emergency stop, \
             the mains",
            "Strg-C in dem Programm, das den Anschluss hält, beendet einen Lauf von antrieb mit seinem Halt; oder der \
             Freigabeeingang, der Not-Halt, das Netz"
        ),
        _ => stops_now(),
    };
    warned(failure, &no_stop(), hint)
}

/// The failure of a stop that did not go out, whatever kept it back.
pub(in crate::command) fn kept_back(failure: Failure) -> Failure {
    warned(failure, &no_stop(), stops_now())
}

fn no_stop() -> Text {
    both!("no stop was sent", "es wurde kein Halt gesendet")
}

/// The danger first, with what became of the stop, and what ends it before any other hint.
fn warned(failure: Failure, told: &Text, hint: Text) -> Failure {
    let message = both!("{told}; {why}", "{told}; {why}", told, why = failure.message);
    let mut failure = Failure { alarm: true, message, ..failure };
    let hints: Vec<Text> = [hint].into_iter().chain(failure.hint.take().map(|hint| *hint)).collect();
    failure.hint(Text::join(&hints, "; "))
}

fn stops_now() -> Text {
    both!(
        "what stops it now: its enable input, the emergency stop, or the mains",
        "was ihn jetzt anhält: sein Freigabeeingang, der Not-Halt oder das Netz"
    )
}

/// The failure of an act that was to take motion away, where the line is the reason: nothing proves that the shaft stands.
pub(super) fn unstopped(failure: Failure, act: Relief, said: bool) -> Failure {
    if !matches!(
        failure.class,
        Class::Silence | Class::Garbled | Class::Interrupted | Class::Refused | Class::Data | Class::Port
    ) {
        return failure;
    }
    unproven(failure, act, said)
}

/// The failure of an act that was to take motion away, and that the drive is found not to obey; as it was found before.
pub(super) fn disobeyed(failure: Failure, act: Relief, said: bool, before: Option<&Situation>) -> Failure {
    let is_off = before.is_some_and(|before| has_power(&before.state) == Some(false));
    if failure.class == Class::Forbidden && !is_off {
        unproven(failure, act, said)
    } else {
        unstopped(failure, act, said)
    }
}

fn unproven(failure: Failure, act: Relief, said: bool) -> Failure {
    let (said, hint) = match act {
        // It may have been lost before the first of its bytes.
        _ if failure.class == Class::Port => {
            (both!("nothing proves that the stop went out", "nichts belegt, dass der Halt hinausging"), stops_now())
        }
        Relief::Zero if said => (
            both!(
                "the setpoint 0 was sent, whether it is obeyed is not known",
                "der Sollwert 0 wurde gesendet; ob er befolgt wird, ist unbekannt"
            ),
            both!(
                "`antrieb statemachine quick-stop` stops it; or its enable input, the emergency stop, the mains",
                "`antrieb statemachine quick-stop` hält ihn an; oder sein Freigabeeingang, der Not-Halt, das Netz"
            ),
        ),
        Relief::Zero => (
            both!("no setpoint was sent", "es wurde kein Sollwert gesendet"),
            both!(
                "what a zero does must be asked from the drive first; `antrieb statemachine quick-stop` goes out at once",
                "was eine Null bewirkt, muss der Antrieb erst sagen; `antrieb statemachine quick-stop` geht sofort hinaus"
            ),
        ),
        _ => (
            both!(
                "the stop was sent, whether it is obeyed is not known",
                "der Halt wurde gesendet; ob er befolgt wird, ist unbekannt"
            ),
            stops_now(),
        ),
    };
    warned(failure, &said, hint)
}

/// Nobody agreed to the rest; whether the shaft was seen to stand since.
pub(super) fn but_said(failure: Failure, act: Relief, rests: bool) -> Failure {
    let why = match failure.code.as_str() {
        "forbidden.not_confirmed" | "forbidden.no_terminal" => {
            both!("nobody agreed to the rest", "dem Übrigen stimmte niemand zu")
        }
        "interrupted.question" => {
            both!("interrupted at the question about the rest", "bei der Frage nach dem Übrigen abgebrochen")
        }
        _ => return unstopped(failure, act, true),
    };
    if !rests {
        return unproven(Failure { message: why, ..failure }, act, true);
    }
    let message = both!(
        "the stop was sent, and is not proven; {why}",
        "der Halt wurde gesendet und ist nicht belegt; {why}",
        why
    );
    Failure { message, ..failure }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_port_that_is_held_names_who_stops_the_drive_by_it() {
        let busy = Failure::new(Class::Port, "port.busy", Text::name("held")).hint(Text::name("close it"));
        let failure = unsent(busy);
        assert!(failure.told().en.starts_with("THE SHAFT MAY STILL TURN: no stop was sent; held"), "{failure:?}");
        let hint = failure.hint.as_deref().map_or("", |hint| &*hint.en);
        assert!(hint.starts_with("Ctrl-C in the program that holds the port") && hint.ends_with("close it"), "{hint}");
        let other = Failure::new(Class::Usage, "usage.port", Text::name("which?"));
        assert_eq!(unsent(other).message.en, "which?");
    }
}
