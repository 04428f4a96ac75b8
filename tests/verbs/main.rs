//! Every verb in process: fine, silent, refused, partial; tables in two languages, JSON, NDJSON, CSV; on the built-in
//! bench, in virtual time.
//!
//! A test says what a user types, and what must come of it: `antrieb("-p sim -a 1 read 372@2").json()`. JSON documents
//! are held against `antrieb schema` wherever they occur. `INSTA_UPDATE=always` writes the snapshots anew.

#![expect(clippy::unwrap_used, reason = "helpers of tests panic as tests do")]

mod agreeable;
mod analog;
mod bus_place;
mod commissioning;
mod gathering;
mod german;
mod guided;
mod judge;
mod lexium;
mod loads_over_sdo;
mod matrix;
mod monitor;
mod pictures;
mod plotting;
mod process_data;
mod profibus;
mod recording;
mod reporting;
mod resolver;
mod run;
mod sdo;
mod system_bus;

/// What a drive holds: parameters and data sets.
mod parameters {
    mod all_or_none;
    mod at_every_telegram;
    mod comparing;
    mod ends;
    mod equal;
    mod groups;
    mod interrupted;
    mod loading;
    mod memory;
    mod over_lines;
    mod own_family;
    pub(crate) mod plant;
    mod reading;
    #[cfg(unix)]
    mod same_port;
    mod saving;
    mod stated;
    mod told;
    mod transactions;
    mod truth;
    mod undo_places;
    mod unproven;
    mod worked;
    mod writing;
}

/// Who is on a line, how it is, and what it does to telegrams.
mod line {
    mod babble;
    mod diagnosing;
    mod finding;
    mod noise;
    mod relocation;
    mod scanning;
    mod searching;
    mod seeking;
    mod sniffing;
    mod sniffing_bus;
    mod talkers;
    mod tape;
    mod twins;
    mod vabus;
}

/// What turns a shaft, and above all what stops it.
mod motion {
    mod asked_for;
    mod at_the_end;
    mod beside;
    mod by_chance;
    mod chosen;
    mod claims;
    mod clock;
    mod coasting;
    mod copies;
    mod counted;
    mod counts_from;
    mod enabled_again;
    mod events;
    mod first_round;
    mod first_telegram;
    mod first_words;
    mod first_zero;
    mod hasty;
    mod heard_again;
    mod held;
    mod ignored;
    mod in_time;
    mod in_turns;
    mod kept;
    mod keypad;
    mod last_words;
    mod leftovers;
    mod moments;
    mod narrow;
    mod not_ours;
    mod others;
    mod otherwise;
    mod pressed;
    mod proofs;
    mod question;
    mod refused;
    mod relief;
    mod rig;
    mod rounds;
    mod runs;
    mod second;
    mod several;
    mod short_of_time;
    mod shown;
    mod slow;
    mod stopping;
    mod stops;
    mod taken;
    mod taken_told;
    mod takeover;
    mod to_the_letter;
    mod told_apart;
    mod told_of_settings;
    mod tries;
    mod unmeasured;
    mod unreached;
    mod within;
    mod written_twice;
    mod zeros;
}

/// What needs no drive: catalogues, files, settings.
mod offline {
    mod broken;
    mod catalogues;
    mod completing;
    mod decoding;
    mod decoding_can;
    mod decoding_dp;
    mod decoding_lexium;
    mod decoding_vabus;
    mod files;
    mod hitachi;
    mod lists;
    mod maps;
    mod naming;
    mod settings;
    mod systembus;
}

/// What is said, in which form, and with which exit code.
mod output {
    mod exits;
    mod forms;
    mod help;
    mod mistyped;
    mod regressions;
    mod screens;
    mod spoken;
    mod typeable;
    mod usage;
    mod wording;
    mod words;
}
