//! The judge of a PROFIBUS line: what the master did that no master may do, by the norm and not by what our own master does.

use super::ear::{gap, syn};
use crate::protocol::dp::control::{Count, Function};
use crate::protocol::dp::{Control, Frame};
use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// Remarks kept; a bench that runs for weeks must not fill the memory.
const MOST_REMARKS: usize = 1_000;
/// The same question so often is no repeat any more (IEC 61158-4-3: max_retry_limit is 1 to 15).
const MOST_REPEATS: u32 = 15;

/// The judge's notebook.
#[derive(Clone, Debug, Default)]
pub(crate) struct Judge {
    remarks: Vec<String>,
    count: u64,
    /// End of the last byte of anybody.
    last: Option<Tick>,
    /// End of the master's last byte, if nobody has spoken since.
    own: Option<Tick>,
    /// The last question to each station, and how often it was asked.
    asked: BTreeMap<u8, (Count, Vec<u8>, u32)>,
    /// What is allowed for where bytes may be read late.
    pub(crate) slack: Span,
}

impl Judge {
    pub(crate) fn remarks(&self) -> &[String] {
        &self.remarks
    }

    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    fn remark(&mut self, at: Tick, text: &str) {
        self.count = self.count.saturating_add(1);
        if self.remarks.len() < MOST_REMARKS {
            self.remarks.push(format!("{} us: {text}", at.as_micros()));
        }
    }

    /// A byte of the master goes over the wire. Whether it begins a telegram says how long it was silent before.
    pub(crate) fn master_byte(&mut self, line: LineSetting, start: Tick, end: Tick, begins: bool) {
        let idle = self.last.map(|last| start.since(last));
        let (needed, borne) = (syn(line), gap(line) + self.slack);
        match idle {
            Some(idle) if begins && idle + self.slack < needed => {
                self.remark(start, &format!("{idle} idle before a telegram; T_SYN is {needed}"));
            }
            Some(idle) if !begins && idle > borne => {
                self.remark(start, &format!("{idle} idle inside a telegram; there may be none"));
            }
            _ => {}
        }
        self.last = Some(end);
        self.own = Some(end);
    }

    /// A byte of somebody else goes over the wire.
    pub(crate) fn other_byte(&mut self, end: Tick) {
        self.last = self.last.max(Some(end));
    }

    /// The master sends into somebody's telegram.
    pub(crate) fn collides(&mut self, at: Tick) {
        self.remark(at, "the master sends while somebody else does");
    }

    /// A whole telegram of the master; `None` if it is none.
    pub(crate) fn telegram(&mut self, at: Tick, frame: Option<&Frame>) {
        let Some(frame) = frame else {
            return self.remark(at, "the master sends what is no telegram");
        };
        let Control::Request { function, count } = frame.control else {
            return self.remark(at, "the master sends an answer");
        };
        let counts = !matches!(function, Function::FdlStatus | Function::SdnLow | Function::SdnHigh);
        if !counts {
            if count != Count::Unused {
                self.remark(at, "a frame count bit in a telegram that has none");
            }
            return;
        }
        if count == Count::Unused {
            return self.remark(at, "a question without a frame count bit");
        }
        let bytes = [&[frame.dsap.unwrap_or(0), frame.ssap.unwrap_or(0), function.code()], &frame.data[..]].concat();
        let bit = |count| matches!(count, Count::First | Count::Bit(true));
        let before = self.asked.get(&frame.to);
        let again = before.filter(|before| before.0 == count || count != Count::First && bit(before.0) == bit(count));
        let (repeats, text) = match (again, before) {
            (Some(again), _) if again.1 != bytes && count != Count::First => {
                (0, Some("a new question under the old bit"))
            }
            (Some(again), _) if again.1 == bytes => (again.2 + 1, None),
            (None, None) if count != Count::First => (0, Some("the first question to a station begins no count")),
            _ => (0, None),
        };
        self.asked.insert(frame.to, (count, bytes, repeats));
        if let Some(text) = text {
            self.remark(at, text);
        }
        if repeats == MOST_REPEATS {
            self.remark(at, "the same question 16 times");
        }
    }
}
