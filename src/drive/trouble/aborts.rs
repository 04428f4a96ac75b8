//! What to do about aborts of SDO that are none of a drive's, but of CiA 301 (table 22).

use crate::text::{Text, both};

/// What to do next.
pub(super) fn hint(code: u32) -> Text {
    let known = HINTS.iter().find(|row| row.0.contains(&code)).map(|row| row.1.clone());
    let what = known.unwrap_or(both!("the manual of the node explains it", "das Handbuch des Knotens erklärt sie"));
    both!(
        "this code is of CiA 301, where a drive tells a number of its own (EM-RES-03 5.10.1), so perhaps another node of CANopen answers; {what}",
        "dieser Code ist aus CiA 301; ein Umrichter nennt dort eine eigene Nummer (EM-RES-03 5.10.1), es antwortet also vielleicht ein anderer \
         CANopen-Knoten; {what}",
        what
    )
}

const HINTS: [(&[u32], Text); 9] = [
    (
        &[0x0602_0000],
        Text::new(
            "it has no such parameter: check the number, and the node (-a)",
            "den Parameter gibt es dort nicht: Nummer und Knoten (-a) prüfen",
        ),
    ),
    (
        &[0x0609_0011],
        Text::new(
            "it has no such data set of the parameter: name it without @, or another one",
            "diesen Datensatz des Parameters gibt es dort nicht: ohne @ oder einen anderen angeben",
        ),
    ),
    (
        &[0x0601_0000, 0x0601_0001, 0x0601_0002],
        Text::new(
            "it can be read or written only; `antrieb params NUMBER` tells what the catalogue says",
            "er ist nur lesbar oder nur schreibbar; `antrieb params NUMMER` zeigt, was der Katalog sagt",
        ),
    ),
    (
        &[0x0607_0010, 0x0607_0012, 0x0607_0013],
        Text::new("it has another width: --type names it", "er hat eine andere Breite: --type nennt sie"),
    ),
    (
        &[0x0609_0030, 0x0609_0031, 0x0609_0032, 0x0604_0043],
        Text::new(
            "check the value; `antrieb params NUMBER` shows the range of the catalogue",
            "den Wert prüfen; `antrieb params NUMMER` zeigt den Bereich des Katalogs",
        ),
    ),
    (
        &[0x0800_0021, 0x0800_0022],
        Text::new(
            "not in the state that it is in: stop it, or take control back to the bus",
            "nicht in dem Zustand, in dem er ist: anhalten oder die Steuerung wieder dem Bus geben",
        ),
    ),
    (
        &[0x0503_0000, 0x0504_0000],
        Text::new(
            "a frame was lost or came twice: try again; two tools on one channel do this too",
            "ein Frame ging verloren oder kam doppelt: noch einmal versuchen; auch zwei Werkzeuge auf einem Kanal bewirken das",
        ),
    ),
    (
        &[0x0504_0001],
        Text::new(
            "it does not know a transfer in one frame, which is all that a drive has",
            "er kennt keine Übertragung in einem Frame, und nur die hat ein Umrichter",
        ),
    ),
    (
        &[0, 0x0800_0000, 0x0800_0020, 0x0606_0000, 0x0504_0005],
        Text::new(
            "it tells no cause that could be acted on; check the parameter and the value",
            "er nennt keine Ursache, mit der sich etwas anfangen ließe; Parameter und Wert prüfen",
        ),
    ),
];

#[cfg(test)]
mod tests {
    use crate::drive::access::{AccessError, Refusal};
    use crate::drive::route::No;
    use crate::exchange::ExchangeError;

    #[test]
    fn an_abort_of_cia_301_is_told_by_what_it_says() {
        for (code, said, hint) in [
            (0x0602_0000, "SDO abort 06020000h (no such object)", "no such parameter"),
            (0x0607_0010, "wrong type or length", "--type"),
            (0x0609_0031, "value too high", "range of the catalogue"),
            (0x0F00_0000, "SDO abort 0F000000h", "the manual of the node"),
        ] {
            let refusal = Refusal { no: No::Abort(code), cause: None, unheard: false, taken: None };
            let failure = AccessError::Refused(refusal).failure(5, None);
            let (message, told) = (failure.message.en.clone(), failure.hint.unwrap().en.clone());
            assert!(message.contains(said) && told.contains(hint) && told.contains("CiA 301"), "{message}: {told}");
        }
        let pieces = AccessError::from(ExchangeError::Pieces { asked: 2 }).failure(5, None);
        assert_eq!((pieces.class.exit(), pieces.code.as_str()), (5, "garbled.in_pieces"));
        assert!(pieces.message.en.contains("in pieces, which no drive does"), "{}", pieces.message.en);
    }
}
