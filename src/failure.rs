//! Failures of the program: classified once, with a stable code, a message and a hint that can be acted on.

use crate::text::{Lang, Text, both};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// How the program ends (CONTRACT: exit codes).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// 1: the answer is no.
    No,
    /// 2: the command line is wrong.
    Usage,
    /// 3: the port cannot be opened, is busy, or was lost.
    Port,
    /// 4: no reply in time.
    Silence,
    /// 5: checksum, framing, wrong responder.
    Garbled,
    /// 6: refused by the drive.
    Refused,
    /// 7: bad data: catalogue, file, value, unknown parameter.
    Data,
    /// 8: not confirmed, or an interlock forbids it.
    Forbidden,
    /// 9: partly done.
    Partial,
    /// 70: a bug of ours.
    Bug,
    /// 130: interrupted.
    Interrupted,
}

impl Class {
    /// Every class with its exit code and what it means; the help text and the man page print it.
    pub const TABLE: [(Class, u8, &'static str); 11] = [
        (Class::No, 1, "the answer is no: nothing found, differences, a fault is present under --check"),
        (Class::Usage, 2, "usage"),
        (Class::Port, 3, "port: cannot open, busy, lost"),
        (Class::Silence, 4, "silence: no reply in time"),
        (Class::Garbled, 5, "garbled: checksum, framing, wrong responder"),
        (Class::Refused, 6, "refused by the drive, with the cause read back"),
        (Class::Data, 7, "bad data: catalogue, parameter file, value out of range, unknown parameter"),
        (Class::Forbidden, 8, "not confirmed, or an interlock forbids it"),
        (Class::Partial, 9, "partly done; the rows say which"),
        (Class::Bug, 70, "a bug of ours"),
        (Class::Interrupted, 130, "interrupted"),
    ];

    /// The exit code of the process.
    pub fn exit(self) -> u8 {
        Self::TABLE.iter().find(|row| row.0 == self).map_or(70, |row| row.1)
    }
}

/// Why the program could not do what it was asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// Decides the exit code.
    pub class: Class,
    /// Stable and dotted: `refused.unknown_parameter`.
    pub code: String,
    /// A shaft may still turn, which is said before anything else.
    pub alarm: bool,
    /// The address that is said before the message, where that does not name the drive itself.
    pub of: Option<u8>,
    /// What was expected and what came; [`Failure::told`] is all of it.
    pub message: Text,
    /// What to do next; boxed, because a failure is handed through many calls.
    pub hint: Option<Box<Text>>,
    /// Facts for machines: address, parameter, bytes …
    pub context: Vec<(&'static str, String)>,
}

impl Failure {
    /// A failure without hint and context.
    pub fn new(class: Class, code: impl Into<String>, message: Text) -> Self {
        Failure { class, code: code.into(), alarm: false, of: None, message, hint: None, context: Vec::new() }
    }

    /// A failure in the words of its causes, the outermost first: `antrieb.toml: the file exists already`.
    pub fn caused(class: Class, code: &str, cause: &anyhow::Error) -> Self {
        Failure::new(class, code, Text::quoted(format_args!("{cause:#}")))
    }

    /// The whole sentence: that a shaft may still turn, whose it is, what came.
    pub fn told(&self) -> Text {
        let said = self.said();
        if self.alarm { Text::join([&may_turn(), &said], ": ") } else { said }
    }

    /// The same with what is to be done about it.
    pub fn told_whole(&self) -> Text {
        let hint = self.hint.as_deref().filter(|hint| !hint.is_empty());
        Text::join([Some(&self.told()), hint].into_iter().flatten(), "; ")
    }

    /// Its message, with the address that it belongs to, and without the alarm.
    pub fn said(&self) -> Text {
        let message = &self.message;
        match self.of {
            Some(address) => both!("address {address}: {message}", "Adresse {address}: {message}", message),
            None => message.clone(),
        }
    }

    /// The same within a longer sentence: `words` takes what was said so far, with whose it is.
    #[must_use]
    pub fn within(self, words: impl FnOnce(Text) -> Text) -> Self {
        Failure { message: words(self.said()), of: None, ..self }
    }

    /// The same with something to do next.
    #[must_use]
    pub fn hint(mut self, hint: Text) -> Self {
        self.hint = Some(Box::new(hint));
        self
    }

    /// The same with one more fact for machines.
    #[must_use]
    pub fn with(mut self, key: &'static str, value: impl fmt::Display) -> Self {
        self.context.push((key, value.to_string()));
        self
    }

    /// The same of a drive whose family was found out.
    #[must_use]
    pub fn of_family(self, drive: &str) -> Self {
        self.with(FAMILY, drive)
    }

    /// No valid answer came, which may be otherwise a moment later. A port that takes no bytes may take them again.
    pub fn is_unheard(&self) -> bool {
        matches!(self.class, Class::Silence | Class::Garbled) || self.code == STUCK
    }

    /// Nothing more comes of the session: its port is gone, or the drive that it was with.
    pub fn is_gone(&self) -> bool {
        self.class == Class::Port || self.code == GONE
    }

    /// The family that the drive was found to be of, or `unknown`.
    pub fn family(&self) -> &str {
        self.context.iter().find(|(key, _)| *key == FAMILY).map_or("unknown", |(_, family)| family)
    }
}

/// The name of a drive's family among the facts for machines.
const FAMILY: &str = "drive";

/// The code of a drive that has fallen silent for good behind a port that is there.
pub const GONE: &str = "silence.gone";

/// The code of a port that takes no bytes.
pub const STUCK: &str = "port.stuck";

/// What comes first where nothing proves that the shaft stands.
pub fn may_turn() -> Text {
    both!("THE SHAFT MAY STILL TURN", "DIE WELLE KANN NOCH DREHEN")
}

/// What is said as soon as it is known that nobody answers a stop.
pub fn unanswered_stop() -> Text {
    both!(
        "{turns}: no valid answer to the stop, which goes on being sent; what stops it now: the enable input, the emergency stop, or the mains",
        "{turns}: keine gültige Antwort auf den Halt, der weiter gesendet wird; was ihn jetzt anhält: der Freigabeeingang, der Not-Halt oder das \
         Netz",
        turns = may_turn()
    )
}

/// For programs and their logs: in English.
impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.told().get(Lang::En))
    }
}

impl std::error::Error for Failure {}
