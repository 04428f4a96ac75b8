//! Every verb in process: fine, silent, refused, partial; tables in two languages, JSON, NDJSON, CSV; on the built-in
//! bench, in virtual time.
//!
//! A test says what a user types, and what must come of it: `antrieb("-p sim -a 1 read 372@2").json()`. JSON documents
//! are held against `antrieb schema` wherever they occur. `INSTA_UPDATE=always` writes the snapshots anew.

#![expect(clippy::unwrap_used, reason = "helpers of tests panic as tests do")]

#[path = "verbs/adapters.rs"]
mod adapters;
#[path = "verbs/babble.rs"]
mod babble;
#[path = "verbs/catalogues.rs"]
mod catalogues;
#[path = "verbs/clock.rs"]
mod clock;
#[path = "verbs/decoding.rs"]
mod decoding;
#[path = "verbs/exits.rs"]
mod exits;
#[path = "verbs/files.rs"]
mod files;
#[path = "verbs/held.rs"]
mod held;
#[path = "verbs/judge.rs"]
mod judge;
#[path = "verbs/leftovers.rs"]
mod leftovers;
#[path = "verbs/lexium.rs"]
mod lexium;
#[path = "verbs/line.rs"]
mod line;
#[path = "verbs/matrix.rs"]
mod matrix;
#[path = "verbs/motion.rs"]
mod motion;
#[path = "verbs/output.rs"]
mod output;
#[path = "verbs/question.rs"]
mod question;
#[path = "verbs/reading.rs"]
mod reading;
#[path = "verbs/regressions.rs"]
mod regressions;
#[path = "verbs/relief.rs"]
mod relief;
#[path = "verbs/run.rs"]
mod run;
#[path = "verbs/scanning.rs"]
mod scanning;
#[path = "verbs/settings.rs"]
mod settings;
#[path = "verbs/sniffing.rs"]
mod sniffing;
#[path = "verbs/stopping.rs"]
mod stopping;
#[path = "verbs/tape.rs"]
mod tape;
#[path = "verbs/twins.rs"]
mod twins;
#[path = "verbs/vabus.rs"]
mod vabus;
#[path = "verbs/words.rs"]
mod words;
#[path = "verbs/worked.rs"]
mod worked;
#[path = "verbs/writing.rs"]
mod writing;
