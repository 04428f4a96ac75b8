//! Lines side by side: what every verb that goes over several of them does alike.

use crate::args::Settings;
use crate::failure::{Class, Failure};
use crate::gate::{Answer, Ask, Question, Reply};
use crate::outcome::{Event, SearchNews, Warning};
use crate::text::{Text, both};
use futures_util::future::join_all;
use std::cell::RefCell;

/// What a verb does with drives that lie on several lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OverLines {
    /// It works on one line. What to do instead, where that is not a call for each line.
    One(Option<Text>),
    /// It works on each line as if its drives alone were meant, on all ports at once.
    Each,
    /// It goes over them in a way of its own.
    Itself,
}

impl OverLines {
    /// The failure of what works on one line, with what to do instead.
    #[must_use]
    pub fn refused(self, failure: Failure) -> Failure {
        match self {
            OverLines::One(Some(instead)) => failure.hint(instead),
            _ => failure,
        }
    }
}

/// Works on these lines, the ports side by side; what is set otherwise on one port is another line of it, and has its turn behind the
/// first. What came of them, in their order.
pub(in crate::command) async fn side_by_side<R>(
    lines: &[Settings],
    observe: &mut dyn FnMut(Event),
    work: impl AsyncFn(&Settings, &mut dyn FnMut(Event)) -> R,
) -> Vec<R> {
    let in_turn = async |lines: &[Settings], observe: &mut dyn FnMut(Event)| {
        let mut came = Vec::new();
        for line in lines {
            came.push(work(line, observe).await);
        }
        came
    };
    ports_side_by_side(lines, observe, in_turn).await
}

/// The same, where each port goes over its lines in its own way, and tells what came of each.
pub(in crate::command) async fn ports_side_by_side<R>(
    lines: &[Settings],
    observe: &mut dyn FnMut(Event),
    work: impl AsyncFn(&[Settings], &mut dyn FnMut(Event)) -> Vec<R>,
) -> Vec<R> {
    let (observe, work) = (RefCell::new(observe), &work);
    let ports = by_port(lines).map(|lines| {
        let observe = &observe;
        async move {
            let port = lines.first().map(port).unwrap_or_default();
            work(lines, &mut |event| (observe.borrow_mut())(named(&port, event))).await
        }
    });
    join_all(ports).await.into_iter().flatten().collect()
}

/// The lines of each port.
pub(in crate::command) fn by_port(lines: &[Settings]) -> impl Iterator<Item = &[Settings]> {
    lines.chunk_by(|one, other| one.port == other.port)
}

/// Refuses a recording of several lines.
pub(in crate::command) fn one_recording(settings: &Settings, lines: usize) -> Result<(), Failure> {
    if lines < 2 || settings.trace.is_none() {
        return Ok(());
    }
    let message = both!(
        "trace: one file holds one line; expected one port",
        "trace: eine Datei fasst eine Leitung; erwartet: ein Anschluss"
    );
    Err(Failure::new(Class::Usage, "usage.trace", message)
        .hint(both!("name the port with -p", "den Anschluss mit -p nennen")))
}

/// The port of a line, as it is told.
pub(in crate::command) fn port(line: &Settings) -> String {
    line.port.as_ref().map_or_else(|| "-".to_owned(), ToString::to_string)
}

/// Nobody is asked for several lines at once.
pub(in crate::command) struct Nobody;

impl Ask for Nobody {
    fn ask<'a>(&'a mut self, _: &'a Question) -> Reply<'a> {
        Box::pin(std::future::ready(Answer::Nobody))
    }

    fn is_there(&self) -> bool {
        false
    }
}

/// What happens on one of several ports, with its name.
pub(in crate::command) fn named(port: &str, event: Event) -> Event {
    match event {
        Event::Note(note) => Event::Note(both!("{port}: {note}", "{port}: {note}", note)),
        Event::Warned(Warning { code, message }) => {
            Event::Warned(Warning { code, message: both!("{port}: {message}", "{port}: {message}", message) })
        }
        event => of_port(port, event),
    }
}

/// The same of what says by itself that it is of a port, or of no use without.
pub(in crate::command) fn of_port(port: &str, event: Event) -> Event {
    match event {
        Event::Sought(news) => Event::Sought(Box::new(SearchNews { is_named: true, ..*news })),
        Event::Progress { done, total, what } => Event::Search { port: port.to_owned(), done, total, what },
        Event::Telegram { at_us, direction, hex, meaning } => {
            let meaning = both!("{port}: {meaning}", "{port}: {meaning}", meaning);
            Event::Telegram { at_us, direction, hex, meaning }
        }
        event => event,
    }
}
