//! A module by raw telegrams, as any master would send them.

use super::bench::{Disturbance, Event, IDENT, Profibus, Setup};
use super::inverter::Kind;
use super::readings::{Reading, Readings};
use crate::profile::Registry;
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::control::{Count, Function, Status};
use crate::protocol::dp::pkw::Pkw;
use crate::protocol::dp::{Control, Diagnosis, EVERYBODY, Frame, Parameters, Service, Telegram};
use crate::protocol::line::{LineSetting, Parity};
use crate::tick::{Span, Tick};

const LINE: LineSetting = LineSetting::rtu(93_750, Parity::Even);
const WATCHDOG: Span = Span::from_millis(200);

/// A master of the norm, for one slave, with nothing clever about it.
struct Hand {
    bus: Profibus,
    now: Tick,
    count: Count,
    layout: Layout,
}

fn setup(kind: Kind, readings: &[Reading]) -> Setup {
    let mut own = Readings::default();
    readings.iter().for_each(|reading| own.add(*reading));
    Setup { kind, address: 3, ident: IDENT, readings: own, set: Vec::new(), events: Vec::new() }
}

impl Hand {
    fn of(setup: Setup) -> Self {
        let registry = Registry::open(&[]).unwrap();
        let bus = Profibus::new(LINE, vec![setup], Disturbance::default(), 1, &registry);
        Hand { bus, now: Tick::ZERO + Span::from_secs(1), count: Count::First, layout: Layout::Ppo(1) }
    }

    fn on(kind: Kind, readings: &[Reading]) -> Self {
        Hand::of(setup(kind, readings))
    }

    fn say(&mut self, to: u8, service: Service, function: Function, count: Count, data: &[u8]) -> Option<Telegram> {
        let sap = service.sap();
        let control = Control::Request { function, count };
        let frame =
            Frame { to, from: 1, control, dsap: sap, ssap: sap.map(|_| 62), data: data.to_vec(), is_fixed: false };
        let bytes = Telegram::Frame(frame).encode();
        self.bus.advance(self.now);
        self.bus.master_sends(self.now, LINE, &bytes);
        self.now = self.now + LINE.chars(bytes.len() as u64) + Span::from_millis(10);
        let heard: Vec<u8> = self.bus.advance(self.now).into_iter().map(|(_, byte)| byte).collect();
        (!heard.is_empty()).then(|| Telegram::decode(&heard).unwrap())
    }

    fn ask(&mut self, service: Service, data: &[u8]) -> Telegram {
        let count = self.count;
        self.count = match count {
            Count::First | Count::Bit(true) => Count::Bit(false),
            _ => Count::Bit(true),
        };
        self.say(3, service, Function::SrdHigh, count, data).expect("an answer")
    }

    fn frame(&mut self, service: Service, data: &[u8]) -> Frame {
        match self.ask(service, data) {
            Telegram::Frame(frame) => frame,
            other => panic!("{other:?}"),
        }
    }

    fn status(&mut self, service: Service, data: &[u8]) -> Status {
        match self.frame(service, data).control {
            Control::Reply { status, .. } => status,
            other @ Control::Request { .. } => panic!("{other:?}"),
        }
    }

    fn diagnosis(&mut self) -> Diagnosis {
        Diagnosis::decode(&self.frame(Service::SlaveDiag, &[]).data).unwrap()
    }

    fn flags(&mut self) -> Vec<&'static str> {
        self.diagnosis().flags().collect()
    }

    fn parameterise(&mut self, status: u8, ident: u16, user: &[u8]) -> Telegram {
        let watchdog = [u8::try_from(WATCHDOG.as_millis() / 10).unwrap(), 1];
        let said = Parameters { status, watchdog, min_tsdr: 11, ident, groups: 0, user: user.to_vec() };
        self.ask(Service::SetPrm, &said.encode())
    }

    fn connect(mut self, layout: Layout, user: &[u8]) -> Self {
        assert_eq!(self.flags(), ["Station_Not_Ready", "Prm_Req"]);
        assert_eq!(self.parameterise(0x88, IDENT, user), Telegram::Ack);
        assert_eq!(self.ask(Service::ChkCfg, layout.bytes()), Telegram::Ack);
        assert_eq!(self.flags(), ["WD_On"]);
        self.layout = layout;
        self
    }

    /// Words go out behind an empty PKW block, if there is one; those that come back.
    fn words(&mut self, words: &[u16]) -> Vec<u16> {
        let pkw = if self.layout.has_pkw() { vec![0; 8] } else { Vec::new() };
        let mut data = [pkw, words.iter().flat_map(|word| word.to_be_bytes()).collect()].concat();
        data.resize(self.layout.length(), 0);
        let said = self.frame(Service::DataExchange, &data).data;
        let own = if self.layout.has_pkw() { &said[8..] } else { &said[..] };
        own.chunks(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]])).collect()
    }

    fn words_for(&mut self, words: &[u16], span: Span) -> Vec<u16> {
        let until = self.now + span;
        let mut last = Vec::new();
        while self.now < until {
            last = self.words(words);
        }
        last
    }

    fn pkw(&mut self, request: Pkw) -> Pkw {
        let exchange = |hand: &mut Hand, request: Pkw| {
            let mut data = request.encode().to_vec();
            data.resize(hand.layout.length(), 0);
            let said = hand.frame(Service::DataExchange, &data).data;
            Pkw::decode(said[..8].try_into().unwrap())
        };
        exchange(self, Pkw::default());
        assert_eq!(exchange(self, Pkw::default()), Pkw::default());
        let mut answer = exchange(self, request);
        assert_eq!(answer, Pkw::default(), "never in the same exchange");
        for _ in 0..10 {
            answer = exchange(self, request);
            if answer.ak != 0 {
                return answer;
            }
        }
        panic!("no answer");
    }

    fn read(&mut self, pnu: u16) -> (u8, u32) {
        let answer = self.pkw(Pkw { ak: 1, pnu, ..Pkw::default() });
        (answer.ak, answer.pwe)
    }

    fn write(&mut self, pnu: u16, pwe: u32) -> (u8, u32) {
        let answer = self.pkw(Pkw { ak: 2, pnu, pwe, ..Pkw::default() });
        (answer.ak, answer.pwe)
    }

    fn silence(&mut self, span: Span) {
        self.now += span;
        self.bus.advance(self.now);
    }

    fn shaft(&self) -> i64 {
        self.bus.shaft(3).unwrap()
    }
}

const SECOND: Span = Span::from_secs(1);
const L200_BLOCK: [u8; 3] = [0xC7, 0xFF, 0xFF];

fn profidrive(readings: &[Reading]) -> Hand {
    let mut hand = Hand::on(Kind::L200, readings).connect(Layout::Ppo(1), &[]);
    assert_eq!(hand.write(928, 1), (1, 1));
    hand
}

/// At 25 Hz by HSW 2000h, with this done about a lost bus.
fn running(readings: &[Reading], bus_lost: u32) -> Hand {
    let mut hand = profidrive(readings);
    assert_eq!(hand.write(703, bus_lost), (1, bus_lost));
    hand.words(&[0x0406, 0x2000]);
    assert_eq!(hand.words(&[0x0406, 0x2000])[0], 0x0231);
    hand.words(&[0x047F, 0x2000]);
    assert_eq!(hand.words(&[0x047F, 0x2000])[0], 0x0237);
    let said = hand.words_for(&[0x047F, 0x2000], SECOND.times(6));
    assert_eq!((said[0], said[1], hand.shaft()), (0x0737, 0x2000, 2_500));
    hand
}

#[test]
fn the_words_of_the_manual_start_and_stop_a_motor() {
    let mut hand = running(&[], 2);
    let said = hand.words_for(&[0x047E, 0], SECOND.times(6));
    assert_eq!((said[0] & 0x0207, hand.shaft()), (0x0201, 0), "{:04X}", said[0]);
    assert_eq!(hand.bus.remarks(), [] as [String; 0]);
}

#[test]
fn a_run_needs_its_edge_and_the_right_to_control() {
    let mut hand = profidrive(&[]);
    hand.words_for(&[0x047F, 0x2000], SECOND);
    assert_eq!(hand.shaft(), 0, "from rest, without 0406");
    let mut hand = profidrive(&[Reading::RunsFromRest]);
    hand.words_for(&[0x047F, 0x2000], SECOND);
    assert_ne!(hand.shaft(), 0);
    let mut hand = Hand::on(Kind::L200, &[]).connect(Layout::Ppo(1), &[]);
    hand.words(&[0x0406, 0x2000]);
    let said = hand.words_for(&[0x047F, 0x2000], SECOND);
    assert_eq!((said[0] & 0x0207, hand.shaft()), (0x0007, 0), "bits 0 to 2 prove no run");
}

#[test]
fn zero_outputs_are_no_stop() {
    for (readings, turns) in
        [(&[][..], true), (&[Reading::WithoutControlRamps], false), (&[Reading::WithoutControlIsLocal], false)]
    {
        let mut hand = running(readings, 2);
        let said = hand.words_for(&[0, 0], SECOND.times(6));
        assert_eq!((said[0], hand.shaft() != 0), (0, turns), "{readings:?}");
    }
}

#[test]
fn what_a_lost_bus_does_is_what_was_set() {
    for (bus_lost, speed) in [(0, 2_500), (1, 1_262), (2, 1_500), (3, 0), (4, 1_500)] {
        let mut hand = running(&[], bus_lost);
        hand.silence(WATCHDOG + SECOND.times(2));
        let shaft = hand.shaft();
        assert!((shaft - speed).abs() < 60, "P.703 = {bus_lost}: {shaft}");
        assert_eq!(hand.flags(), ["Station_Not_Ready", "Prm_Req"]);
        let left = [0; 12];
        assert_eq!(hand.status(Service::DataExchange, &left), Status::NoService);
    }
}

#[test]
fn unlock_counts_as_a_lost_bus_or_does_not() {
    for (readings, turns) in [(&[][..], false), (&[Reading::UnlockIsNoLoss], true)] {
        let mut hand = running(readings, 3);
        hand.parameterise(0x40, IDENT, &[]);
        hand.silence(SECOND);
        assert_eq!(hand.shaft() != 0, turns, "{readings:?}");
    }
}

#[test]
fn the_basic_block_moves_the_motor_and_hands_it_to_the_terminals() {
    let mut setup = setup(Kind::L200, &[]);
    setup.events = vec![(Tick::ZERO + SECOND.times(20), Event::Contact(true))];
    let mut hand = Hand::of(setup).connect(Layout::Basic, &L200_BLOCK);
    let said = hand.words_for(&[0x0051, 2_000, 50, 50], SECOND.times(4));
    assert_eq!((said[0], said[1], said[3], hand.shaft()), (0x0051, 2_000, 1, 2_000));
    let said = hand.words_for(&[0x0050, 2_000, 50, 50], SECOND.times(4));
    assert_eq!((said[0], said[1], said[3], hand.shaft()), (0x0050, 0, 0, 0));
    hand.words_for(&[0x0050, 2_000, 50, 50], SECOND.times(12));
    assert_eq!(hand.shaft(), 0, "the contact is closed, and the bus has the start");
    hand.words_for(&[0; 4], SECOND.times(4));
    assert_eq!(hand.shaft(), 1_000, "zero outputs hand it to the terminals");
}

#[test]
fn a_trip_is_told_by_a_diagnosis_and_cleared_by_an_edge() {
    let mut setup = setup(Kind::Sj200, &[]);
    setup.events = vec![(Tick::ZERO + SECOND.times(3), Event::Trip)];
    let mut hand = Hand::of(setup).connect(Layout::Ppo(1), &[]);
    hand.write(928, 1);
    hand.words_for(&[0x0406, 0x2000], SECOND);
    hand.words_for(&[0x047F, 0x2000], SECOND.times(2));
    let said = hand.words(&[0x047F, 0x2000]);
    assert_eq!(said[0] & 0x000E, 0x0008, "{:04X}", said[0]);
    let outputs = [0; 12];
    assert_eq!(hand.status(Service::DataExchange, &outputs), Status::DataHigh);
    let found = hand.diagnosis();
    assert_eq!(found.flags().collect::<Vec<_>>(), ["Ext_Diag", "WD_On"]);
    assert_eq!(hand.status(Service::DataExchange, &outputs), Status::DataLow);
    assert_eq!((hand.read(300), hand.write(616, 1), hand.read(300)), ((1, 0), (1, 1), (1, 0x25)));
    hand.words(&[0x0406, 0]);
    hand.words(&[0x0486, 0]);
    assert_eq!(hand.words(&[0x0406, 0])[0] & 0x0008, 0);
}

#[test]
fn parameters_are_answered_as_the_table_says() {
    let mut hand = Hand::on(Kind::L200, &[]).connect(Layout::Ppo(1), &[]);
    assert_eq!(hand.read(624), (1, 0x20));
    assert_eq!(hand.read(7), (1, 0x0000_FC18), "-1000 is 10.00 s");
    assert_eq!(hand.read(219), (2, 0), "four bytes");
    assert_eq!((hand.read(37), hand.read(599)), ((7, 0), (7, 0)), "an SJ200 alone has 37, nobody 599");
    assert_eq!((hand.write(614, 1), hand.write(703, 9)), ((7, 1), (7, 2)));
    let array = |ak, pnu, ind, pwe| Pkw { ak, pnu, ind, pwe, spm: false };
    let ends = |said: Pkw| (said.ak, said.pwe);
    // The worked example of 4.1, and what is no element.
    let said = hand.pkw(array(7, 915, 0x0100, 34));
    assert_eq!((said.encode()[..4].to_vec(), said.pwe), (vec![0x43, 0x93, 0x01, 0x00], 34));
    assert_eq!(ends(hand.pkw(array(6, 915, 0x0100, 0))), (4, 34));
    assert_eq!(ends(hand.pkw(array(6, 915, 0x0900, 0))), (7, 3));
    assert_eq!(ends(hand.pkw(array(6, 614, 0x0100, 0))), (7, 4));
    assert_eq!(ends(hand.pkw(array(9, 964, 0, 0))), (6, 5));
    assert_eq!(ends(hand.pkw(array(1, 915, 0, 0))), (7, 3));
    assert_eq!(hand.write(927, 0), (1, 0));
    assert_eq!((hand.read(624), hand.read(927), hand.write(703, 1)), ((8, 0), (1, 0), (8, 0)));
    let mut hand = Hand::on(Kind::L200, &[Reading::SignedPwe]).connect(Layout::Ppo(1), &[]);
    assert_eq!(hand.read(7), (1, 0xFFFF_FC18));
}

#[test]
fn a_mapped_word_is_written_and_shown() {
    let mut hand = Hand::on(Kind::L200, &[]).connect(Layout::Ppo(2), &[]);
    assert_eq!(hand.pkw(Pkw { ak: 7, pnu: 915, ind: 0x0100, pwe: 34, spm: false }).ak, 4);
    let said = [hand.words(&[0, 0, 0x01F4]), hand.words(&[0, 0, 0x01F4])].concat();
    assert_eq!(said.last_chunk::<4>(), Some(&[0x01F4, 0, 0, 0]));
    assert_eq!(hand.read(34), (1, 0), "the zero in the word of the request was written as well");
}

#[test]
fn a_ramp_that_is_written_is_the_ramp_of_the_motor() {
    let mut hand = profidrive(&[]);
    // 0.50 s and 5.00 s in the code of the ramps (5.5 index 7): -50 and -500.
    for (code, second) in [(0xFFCE_u32, 5_000), (0xFE0C, 1_000)] {
        assert_eq!(hand.write(7, code), (1, code));
        hand.words(&[0x0406, 0]);
        hand.words_for(&[0x047F, 0x4000], Span::from_secs(1));
        assert!((second - 100..=second + 100).contains(&hand.shaft()), "{code:04X}: {}", hand.shaft());
        hand.words_for(&[0x047E, 0x4000], Span::from_secs(30));
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let mut hand = Hand::on(Kind::L200, &[]);
    hand.parameterise(0x80, IDENT + 1, &[]);
    assert_eq!(hand.flags(), ["Station_Not_Ready", "Prm_Fault", "Prm_Req"]);
    for (user, readings, fault) in [
        (&[][..], &[][..], "Cfg_Fault"),
        (&[0x47, 0xFF, 0xFF], &[], "Cfg_Fault"),
        (&[0x47, 0xFF, 0xFF], &[Reading::SeriesIsPrmFault], "Prm_Fault"),
    ] {
        let mut hand = Hand::on(Kind::L200, readings);
        hand.parameterise(0x80, IDENT, user);
        assert_eq!(hand.ask(Service::ChkCfg, Layout::Basic.bytes()), Telegram::Ack);
        assert_eq!(hand.flags(), ["Station_Not_Ready", fault, "Prm_Req"]);
    }
    let mut hand = Hand::on(Kind::L200, &[]);
    assert_eq!(hand.status(Service::ChkCfg, &[0xF1]), Status::NoService, "before Set_Prm");
    assert_eq!(hand.status(Service::DataExchange, &[0; 4]), Status::NoService);
}

#[test]
fn the_same_question_gets_the_same_answer_and_a_repeat_does_nothing_twice() {
    let mut hand = Hand::on(Kind::L200, &[]).connect(Layout::Ppo(3), &[]);
    let first = hand.say(3, Service::DataExchange, Function::SrdHigh, Count::First, &[4, 6, 0x20, 0]);
    let next = hand.say(3, Service::DataExchange, Function::SrdHigh, Count::Bit(false), &[4, 6, 0x20, 0]);
    let again = hand.say(3, Service::DataExchange, Function::SrdHigh, Count::Bit(false), &[4, 6, 0x20, 0]);
    assert!(first.is_some() && next == again);
    assert_eq!(hand.bus.remarks(), [] as [String; 0]);
    hand.say(3, Service::DataExchange, Function::SrdHigh, Count::Bit(false), &[0, 0, 0, 0]);
    assert!(hand.bus.remarks()[0].contains("old bit"), "{:?}", hand.bus.remarks());
}

#[test]
fn only_its_master_commands_it() {
    let mut hand = running(&[Reading::ClearIsLoss], 3);
    hand.say(EVERYBODY, Service::GlobalControl, Function::SdnHigh, Count::Unused, &[0x02, 0x01]);
    assert_ne!(hand.shaft(), 0, "another group");
    hand.say(EVERYBODY, Service::GlobalControl, Function::SdnHigh, Count::Unused, &[0x02, 0]);
    hand.silence(Span::from_millis(400));
    assert_eq!(hand.shaft(), 0);
}

#[test]
fn telegrams_too_close_together_and_torn_ones_are_not_heard() {
    let status = [0x10, 0x03, 0x01, 0x49, 0x4D, 0x16];
    let sent = |pieces: &[(u64, &[u8])]| {
        let (mut hand, mut heard) = (Hand::on(Kind::L200, &[]), 0);
        for (after, piece) in pieces {
            hand.now += Span::from_micros(*after);
            heard += hand.bus.advance(hand.now).len();
            hand.bus.master_sends(hand.now, LINE, piece);
            hand.now += LINE.chars(piece.len() as u64);
        }
        hand.now += SECOND;
        (heard + hand.bus.advance(hand.now).len(), hand.bus.remarks().len())
    };
    assert_eq!(sent(&[(0, &status)]), (6, 0));
    assert_eq!(sent(&[(0, &status[..3]), (100, &status[3..])]), (0, 1), "torn");
    assert_eq!(sent(&[(0, &status), (5_000, &status)]), (12, 0));
    let (heard, remarks) = sent(&[(0, &status), (300, &status)]);
    assert!(heard < 12 && remarks > 0, "into the answer, or before T_SYN");
}
