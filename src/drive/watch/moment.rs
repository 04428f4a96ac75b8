//! The moments of a watch: a trigger that came true, a drive that went into a fault.

use super::station::Station;
use super::{Source, Watch, Window, decimal, trigger, trip};
use crate::outcome::{Event, Record, Sample, TriggerNews, Waits};

impl Watch<'_> {
    /// Tells of triggers that came true and of a fault that came, before the sample that shows them.
    pub(super) fn mark_moments(&mut self, session: &mut impl Source, station: &mut Station, sample: &Sample) {
        for news in station.news(sample) {
            let record = match news {
                Record::Trigger(_) if self.rounds.window.once && self.tally.triggers > 0 => continue,
                Record::Trigger(news) => {
                    self.tally.triggers += 1;
                    session.tell(Event::Note(trigger::told(&news)));
                    if self.rounds.window.once {
                        let end = session.now() + self.rounds.window.post;
                        self.end = self.end.filter(|(known, _)| *known < end).or(Some((end, "trigger")));
                    }
                    Record::Trigger(TriggerNews { n: self.tally.triggers, ..news })
                }
                Record::Trip(trip) => {
                    session.tell(Event::Note(trip::told(&trip)));
                    Record::Trip(trip)
                }
                other => other,
            };
            self.emit(session, record);
        }
    }

    /// What is waited for.
    pub(super) fn waits(&self) -> Option<Waits> {
        let (triggers, Window { pre, post, once }) = (self.triggers.clone(), self.rounds.window);
        (!triggers.is_empty()).then(|| Waits { triggers, pre: decimal(pre), post: decimal(post), once })
    }
}
