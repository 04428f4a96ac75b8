//! What the live view shows of what happened on the bench, as text: `docs/screens`. `UPDATE=1 cargo test --test verbs pictures` writes them anew.

use antrieb::outcome::{Event, Record};
use antrieb::render::Picture;
use antrieb::text::Lang;
use std::path::Path;

/// When a picture is taken: so many samples into a part of a run, of the view or of its diagnosis.
pub(crate) type Moment = (&'static str, usize, bool);

/// Holds the pictures of a story against `docs/screens/NAME.*.txt`.
#[expect(clippy::disallowed_methods, reason = "UPDATE=1 is how a test is told to write")]
pub(crate) fn are_documented(name: &str, story: &[Event], moments: &[Moment]) {
    for (lang, ending) in [(Lang::En, "en"), (Lang::De, "de")] {
        let text = pictures(story, moments, lang);
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("docs/screens/{name}.{ending}.txt"));
        if std::env::var_os("UPDATE").is_some() {
            std::fs::write(&file, &text).unwrap();
        }
        assert_eq!(std::fs::read_to_string(&file).unwrap_or_default(), text, "UPDATE=1 writes {name} anew");
    }
}

fn pictures(story: &[Event], moments: &[Moment], lang: Lang) -> String {
    let (mut picture, mut text) = (Picture::new(lang), String::new());
    let (mut phase, mut samples, mut left) = ("", 0, moments.iter().peekable());
    for event in story {
        match event {
            Event::Record(record) => {
                match &**record {
                    // The bench lies in a folder of its own.
                    Record::Start(start) => {
                        let port = "sim".to_owned();
                        picture.record(&Record::Start(antrieb::outcome::StreamStart { port, ..start.clone() }));
                        continue;
                    }
                    Record::Run(news) if news.phase != phase => (phase, samples) = (news.phase, 0),
                    Record::Sample(_) => samples += 1,
                    _ => {}
                }
                picture.record(record);
            }
            // Where the settings come from is told under `-v` alone.
            Event::Note(note) if !note.en.contains("sim:") => picture.note(note.get(lang)),
            _ => continue,
        }
        while let Some((_, _, diagnoses)) = left.next_if(|(at, count, _)| *at == phase && *count <= samples) {
            picture.diagnoses(*diagnoses);
            let page = picture.lines(80, 24);
            text += &format!("{}\n{}\n", "-".repeat(80), page.join("\n"));
        }
    }
    assert_eq!(left.next(), None, "{text}");
    text
}
