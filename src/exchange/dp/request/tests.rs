//! What is an answer to a request over the PKW channel, and what stands there from before.

use super::*;

const PLAIN: Place = Place { pnu: 303, element: None };
const ELEMENT: Place = Place { pnu: 918, element: Some(2) };
/// Answers (manual 4.1.1): a word, a word of an element, no, no right.
const WORD: u8 = 1;
const ELEMENT_WORD: u8 = 4;
const REFUSED: u8 = 7;
const NO_RIGHT: u8 = 8;

fn said(ak: u8, pnu: u16, pwe: u32) -> Pkw {
    Pkw { ak, pnu, pwe, ..Pkw::default() }
}

/// A request whose channel was seen empty.
fn asked(place: Place) -> Request {
    let mut request = Request::read(place, Tick::ZERO);
    assert_eq!(request.inputs(Tick::ZERO, Pkw::default()), None);
    request
}

#[test]
fn what_stands_in_the_channel_before_it_was_empty_is_no_answer() {
    for old in [said(WORD, 303, 5), said(REFUSED, 303, 0), said(NO_RIGHT, 303, 0)] {
        let mut request = Request::read(PLAIN, Tick::ZERO);
        assert_eq!(request.outputs(), Pkw::default(), "nothing is asked into a channel that is not empty");
        assert_eq!(request.inputs(Tick::ZERO, old), None, "{old:?}");
        assert_eq!(request.inputs(Tick::ZERO, Pkw::default()), None);
        assert_eq!(request.outputs(), request.asked());
    }
}

#[test]
fn an_answer_that_names_another_parameter_is_none() {
    for ak in [WORD, REFUSED, NO_RIGHT] {
        assert_eq!(asked(PLAIN).inputs(Tick::ZERO, said(ak, 304, 5)), None, "{ak}");
    }
    assert_eq!(asked(PLAIN).inputs(Tick::ZERO, said(WORD, 303, 5)), Some(Told::Value(5)));
    assert_eq!(asked(PLAIN).inputs(Tick::ZERO, said(REFUSED, 303, 2)), Some(Told::Refused(2)));
    assert_eq!(asked(PLAIN).inputs(Tick::ZERO, said(NO_RIGHT, 303, 0)), Some(Told::NoRight));
}

#[test]
fn an_element_is_answered_by_its_own_value_alone() {
    let of = |ak: u8, element: u16| Pkw { ind: element << 8, ..said(ak, 918, 5) };
    assert_eq!(asked(ELEMENT).inputs(Tick::ZERO, of(WORD, 2)), None, "the value of no element");
    assert_eq!(asked(ELEMENT).inputs(Tick::ZERO, of(ELEMENT_WORD, 1)), None, "another element");
    assert_eq!(asked(ELEMENT).inputs(Tick::ZERO, of(ELEMENT_WORD, 2)), Some(Told::Value(5)));
}

/// Each half has three seconds of its own.
#[test]
fn a_channel_that_does_not_answer_is_silent_behind_three_seconds() {
    let late = PATIENCE + Span::from_micros(1);
    let old = said(WORD, 303, 5);
    let mut request = Request::read(PLAIN, Tick::ZERO);
    assert_eq!(request.inputs(Tick::ZERO + PATIENCE, old), None);
    assert_eq!(request.inputs(Tick::ZERO + late, old), Some(Told::Silence));

    let begun = Tick::ZERO + PATIENCE;
    let mut request = Request::read(PLAIN, Tick::ZERO);
    assert_eq!(request.inputs(begun, Pkw::default()), None);
    assert_eq!(request.inputs(begun + PATIENCE, Pkw::default()), None);
    assert_eq!(request.inputs(begun + late, Pkw::default()), Some(Told::Silence));
    assert_eq!(request.inputs(begun + late, old), Some(Told::Value(5)), "an answer that came late is one");
}

#[test]
fn only_a_write_changes_something() {
    for place in [PLAIN, ELEMENT] {
        assert!(!Request::read(place, Tick::ZERO).writes());
        let write = Request::write(place, 7, Tick::ZERO);
        assert_eq!((write.writes(), write.asked().pwe), (true, 7));
    }
}
