//! The bench as a master of VABus meets it.

use crate::profile::Registry;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::protocol::vabus::{
    Address, Data, DataSet, ENQ, EOT, ETX, Header, ParamNumber, Reply, Request, SystemNode, bcc,
};
use crate::simulator::{Bench, Sin};
use crate::tick::{Span, Tick};

const LINE: LineSetting = LineSetting::vabus(19_200);
const ACU: &str = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\n";
/// Reads P.372@2 of drive 1 (sources A4).
const READ: &str = "04 41 30 32 33 37 32 05";

/// A master that asks one second after the last question.
struct Master {
    bench: Bench,
    now: Tick,
    line: LineSetting,
}

fn header(number: u16, set: u8) -> Header {
    let (set, number) = (DataSet::new(set).unwrap(), ParamNumber::new(number).unwrap());
    Header { node: SystemNode::SELF, set, number }
}

fn behind(node: u8, number: u16, set: u8) -> Header {
    Header { node: SystemNode::new(node).unwrap(), ..header(number, set) }
}

fn hex(text: &str) -> Vec<u8> {
    text.split(' ').map(|byte| u8::from_str_radix(byte, 16).unwrap()).collect()
}

fn word(number: u16) -> Option<Data> {
    Some(Data::word(number))
}

impl Master {
    fn on(text: &str) -> Self {
        let bench = Bench::from_toml("test.toml", text, &Registry::open(&[]).unwrap()).unwrap();
        Master { bench, now: Tick::ZERO, line: LINE }
    }

    /// Sends, and returns what comes within a second.
    fn send(&mut self, bytes: &[u8]) -> Vec<u8> {
        self.bench.master_sends(self.now, self.line, bytes);
        self.now += Span::from_secs(1);
        self.bench.advance(self.now).into_iter().map(|heard| heard.1).collect()
    }

    fn ask(&mut self, request: &Request) -> Option<Reply> {
        let heard = self.send(&request.encode());
        (!heard.is_empty()).then(|| Reply::decode(&heard).unwrap())
    }

    /// The value of drive 1 or of a drive behind it; `None` if it refuses.
    fn read(&mut self, header: Header) -> Option<Data> {
        let address = Address::drive(1).unwrap();
        match self.ask(&Request::Enquiry { address, header }).unwrap() {
            Reply::Value { header: told, data, .. } => {
                assert_eq!(told, Header { set: header.set.as_replied(), ..header });
                Some(data)
            }
            Reply::Nak { .. } => None,
            Reply::Ack { .. } => panic!("ACK to an enquiry"),
        }
    }

    /// Whether drive 1 takes the value.
    fn write(&mut self, header: Header, data: Data) -> bool {
        let address = Address::drive(1).unwrap();
        match self.ask(&Request::Select { address, header, data }).unwrap() {
            Reply::Ack { .. } => true,
            Reply::Nak { .. } => false,
            Reply::Value { .. } => panic!("a value to a SELECT"),
        }
    }

    /// The error register of drive 1.
    fn cause(&mut self) -> Option<u16> {
        self.read(header(11, 0)).and_then(|data| data.as_word())
    }

    fn is_innocent(&self) {
        assert_eq!(self.sins(), Vec::<Sin>::new());
    }

    fn sins(&self) -> Vec<Sin> {
        self.bench.remarks().iter().map(|remark| remark.kind).collect()
    }
}

#[test]
fn the_worked_telegrams() {
    let three = format!("{ACU}[[drive]]\nmodel = \"act\"\nprotocol = \"vabus\"\naddress = 3\n");
    let mut master = Master::on(&three);
    for (asked, told) in [
        (READ, "41 02 30 32 33 37 32 30 34 30 35 36 45 03 45"),
        ("04 43 02 30 34 33 37 36 30 34 30 30 30 46 03 47", "43 06"),
        ("04 41 30 30 34 38 31 05", "41 02 30 30 34 38 31 30 38 30 30 30 30 30 33 45 38 03 48"),
        ("04 41 02 30 30 34 38 30 30 38 46 46 46 46 44 31 32 30 03 40", "41 06"),
    ] {
        assert_eq!(master.send(&hex(asked)), hex(told), "{asked}");
    }
    assert_eq!(master.bench.drive(3).unwrap().eeprom(376, 4), Some(15));
    assert_eq!(master.bench.drive(1).unwrap().eeprom(480, 2), Some(-12_000));
    master.is_innocent();
}

#[test]
fn a_factory_fresh_drive_speaks_vabus_and_no_modbus() {
    let mut master = Master::on(ACU);
    let drive = master.bench.drive(1).unwrap();
    let settings = [395, 10, 394, 1375, 1376].map(|number| drive.ram(number, 0));
    assert_eq!(settings, [Some(0), Some(4), Some(1), Some(0), Some(1)]);
    assert_eq!((drive.protocol(), drive.line()), ("vabus", LINE));
    master.line = LineSetting::rtu(19_200, Parity::Even);
    assert_eq!(master.send(&Framing::Rtu.encode(1, &[3, 1, 0x9B, 0, 1])), [0u8; 0]);
    assert_eq!(master.bench.totals().ignored.wrong_protocol, 1);
}

#[test]
fn a_reply_begins_after_10_ms() {
    let mut bench = Master::on(ACU).bench;
    bench.master_sends(Tick::ZERO, LINE, &hex(READ));
    let asked = Tick::ZERO + LINE.chars(8);
    let heard = bench.advance(Tick::ZERO + Span::from_secs(1));
    assert_eq!(heard.first().unwrap().0, asked + Span::from_millis(10) + LINE.chars(1));
    assert_eq!(heard.last().unwrap().0, asked + Span::from_millis(10) + LINE.chars(15));
}

#[test]
fn memories_and_how_replies_name_them() {
    let mut master = Master::on(ACU);
    assert!(master.write(header(372, 7), Data::word(1_500)));
    assert_eq!((master.read(header(372, 2)), master.read(header(372, 7))), (word(1_390), word(1_500)));
    assert_eq!(master.bench.totals().eeprom_writes, 0);
    assert!(master.write(header(372, 2), Data::word(1_400)));
    assert_eq!((master.bench.totals().eeprom_writes, master.read(header(372, 7))), (1, word(1_400)));
    assert_eq!((master.read(header(372, 0)), master.cause()), (None, Some(9)));
    master.is_innocent();
}

#[test]
fn causes_of_nak() {
    let mut master = Master::on(ACU);
    let text = |text: &[u8]| Data::text(text).unwrap();
    for (number, set, data, cause) in [
        (1_599, 0, None, 11),
        (10, 1, None, 2),
        (484, 0, None, 3),
        (19, 0, None, 11),
        (260, 0, word(0), 4),
        (395, 0, word(9), 1),
        (480, 0, word(0), 14),
        (372, 2, Some(Data::long(1)), 14),
        (372, 2, Some(text(b"5")), 14),
        (372, 2, Some(text(b"05dc")), 13),
    ] {
        match data {
            None => assert_eq!(master.read(header(number, set)), None),
            Some(data) => assert!(!master.write(header(number, set), data)),
        }
        assert_eq!((master.cause(), master.cause()), (Some(cause), Some(0)), "P.{number}@{set}");
    }
    master.is_innocent();
}

#[test]
fn after_a_nak_no_select_is_taken_until_the_register_was_read() {
    let mut master = Master::on(ACU);
    assert_eq!(master.read(header(1_599, 0)), None);
    assert_eq!(master.read(header(372, 2)), word(1_390));
    assert!(!master.write(header(372, 2), Data::word(1_400)));
    assert_eq!(master.sins(), [Sin::Locked]);
    assert_eq!((master.cause(), master.read(header(372, 2))), (Some(11), word(1_390)));
    assert!(master.write(header(372, 2), Data::word(1_400)));
    assert_eq!(master.sins(), [Sin::Locked]);
}

#[test]
fn what_gets_no_answer_and_what_gets_nak() {
    let mut master = Master::on(ACU);
    let good = hex("04 41 02 30 32 33 37 32 30 34 30 35 37 38 03");
    let select = |check: u8| [good.as_slice(), &[check]].concat();
    let check = bcc(&good[3..14]);
    assert_eq!(master.send(&select(check ^ 1)), hex("41 15"));
    assert_eq!((master.cause(), master.read(header(372, 2))), (Some(12), word(1_390)));
    for telegram in [
        "04 42 30 32 33 37 32 05", // another drive
        "04 60 30 32 33 37 32 05", // an enquiry to all
        "04 41 30 32 67 37 32 05", // no number
        "04 41 20 32 33 37 32 05", // no node
        "41 30 32 33 37 32 05",    // no EOT
        "04 41 30 32 33 37 32 06", // another control code
    ] {
        assert_eq!(master.send(&hex(telegram)), [0u8; 0], "{telegram}");
    }
    use Sin::{BroadcastRead, Malformed};
    assert_eq!(master.sins(), [Malformed, BroadcastRead, Malformed, Malformed, Malformed, Malformed]);
    assert_eq!(master.send(&select(check)), hex("41 06"));
}

#[test]
fn everybody_obeys_a_broadcast_and_nobody_answers() {
    let mut master = Master::on(&format!("{ACU}{}address = 2", ACU));
    let select = Request::Select { address: Address::BROADCAST, header: header(372, 0), data: Data::word(1_500) };
    assert_eq!(master.ask(&select), None);
    let values = [1, 2].map(|id| master.bench.drive(id).unwrap().ram(372, 3));
    assert_eq!((values, master.bench.totals().broadcasts), ([Some(1_500), Some(1_500)], 1));
    master.is_innocent();
}

#[test]
fn strings_exist_where_the_file_says_so_and_modbus_has_none() {
    let mut master = Master::on(&format!("{ACU}set = {{ \"17\" = \"-\", \"19\" = \"00002A5D00660028\" }}"));
    assert_eq!(
        master.send(&hex("04 41 30 30 30 31 39 05")),
        hex("41 02 30 30 30 31 39 31 36 30 30 30 30 32 41 35 44 30 30 36 36 30 30 32 38 03 34")
    );
    assert!(master.write(header(17, 0), Data::text(b"002100021100213").unwrap()));
    assert_eq!((master.read(header(17, 0)), master.cause()), (None, Some(3)));
    assert!(!master.write(header(19, 0), Data::text(b"x").unwrap()));
    assert_eq!(master.cause(), Some(4));
}

const CUBE: &str = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\nnodes = [{ id = 17, model = \"acu\", modules = [\"EM-RES-03\"], set = { \"372\" = 2800 } }, { id = 63, model = \"act\" }]\nset = { \"19\" = \"x\" }\n";

#[test]
fn nodes_of_the_system_bus_are_reached_through_their_master() {
    let mut master = Master::on(CUBE);
    assert_eq!(master.send(&hex("04 41 51 32 33 37 32 05")).get(..7), Some(&hex("41 02 51 32 33 37 32")[..]));
    assert_eq!((master.read(behind(17, 372, 2)), master.read(behind(63, 372, 7))), (word(2_800), word(1_390)));
    assert!(master.write(behind(17, 480, 1), Data::long(-1_000_i32 as u32)));
    assert_eq!(master.read(behind(17, 480, 1)), Some(Data::long(-1_000_i32 as u32)));
    assert_eq!(master.read(header(480, 1)), Some(Data::long(500)));
    master.is_innocent();
}

#[test]
fn causes_of_the_system_bus_stand_in_the_register_of_the_master() {
    let mut master = Master::on(CUBE);
    for (header, cause) in [
        (behind(18, 372, 2), 20),
        (behind(17, 19, 0), 21),
        (behind(17, 1_599, 0), 11),
        // Only the node has the module; the master must know the parameter too.
        (behind(17, 382, 0), 11),
        (behind(17, 484, 0), 3),
    ] {
        assert_eq!(master.read(header), None, "{header:?}");
        assert_eq!(master.read(behind(17, 11, 0)), word(0));
        assert!(!master.write(header, Data::word(0)), "still locked");
        assert_eq!(master.cause(), Some(cause), "{header:?}");
    }
    assert!(!master.write(behind(17, 260, 0), Data::word(0)));
    assert_eq!(master.cause(), Some(4));
    let mut alone = Master::on(ACU);
    assert_eq!((alone.read(behind(1, 372, 2)), alone.cause()), (None, Some(20)));
}

#[test]
fn a_node_that_restarts_is_not_reachable_for_3_s() {
    let mut master = Master::on(CUBE);
    assert!(master.write(behind(17, 372, 7), Data::word(1_500)));
    assert!(master.write(behind(17, 34, 0), Data::word(123)));
    assert_eq!((master.read(behind(17, 372, 7)), master.cause()), (None, Some(20)));
    master.now += Span::from_secs(1);
    assert_eq!(master.read(behind(17, 372, 7)), word(2_800));
}

#[test]
fn a_node_turns_its_shaft() {
    let mut master = Master::on(CUBE);
    for (number, data) in [(412, Data::word(1)), (484, Data::long(1_000)), (410, Data::word(0x0F))] {
        assert!(master.write(behind(63, number, 0), data));
    }
    master.read(behind(63, 411, 0));
    let totals = master.bench.totals();
    assert_eq!((totals.turning, totals.energised), (1, 1));
}

#[test]
fn protocol_and_address_change_after_the_reply_speed_and_parity_after_a_reset() {
    let mut master = Master::on(ACU);
    assert!(master.write(header(394, 0), Data::word(9)));
    assert_eq!(master.send(&hex(READ)), [0u8; 0]);
    let at_9 = |header, data| Request::Select { address: Address::drive(9).unwrap(), header, data };
    let ack = Some(Reply::Ack { address: Address::drive(9).unwrap() });
    assert_eq!(master.ask(&at_9(header(1_375, 0), Data::word(1))), ack);
    assert_eq!(master.ask(&at_9(header(10, 0), Data::word(6))), ack);
    assert_eq!(master.ask(&at_9(header(395, 0), Data::word(2))), ack);
    // The parity of Modbus and the speed are those of the last power-on.
    master.line = LineSetting::rtu(19_200, Parity::Even);
    let read = Framing::Rtu.encode(1, &[3, 0x01, 0x8B, 0, 1]);
    assert_eq!(master.send(&read), Framing::Rtu.encode(1, &[3, 2, 0, 2]));
    assert!(!master.send(&Framing::Rtu.encode(1, &[6, 0, 34, 0, 123])).is_empty());
    master.now += Span::from_secs(3);
    master.line = LineSetting::rtu(115_200, Parity::Odd);
    assert_eq!(master.send(&read), Framing::Rtu.encode(1, &[3, 2, 0, 2]));
    // Back: the speed stays, the format is that of VABus.
    assert!(!master.send(&Framing::Rtu.encode(1, &[6, 0x01, 0x8B, 0, 0])).is_empty());
    master.line = LineSetting::vabus(115_200);
    assert!(matches!(master.ask(&at_9(header(395, 0), Data::word(1))), Some(Reply::Ack { .. })));
    assert_eq!(master.bench.drives().next().unwrap().protocol(), "p-bus");
    assert_eq!(master.ask(&at_9(header(395, 0), Data::word(0))), None);
}

#[test]
fn a_restart_and_a_new_protocol_unlock() {
    let mut master = Master::on(ACU);
    assert_eq!(master.read(header(1_599, 0)), None);
    master.bench.drive_mut(1).unwrap().power_cycle(master.now);
    master.now += Span::from_secs(3);
    assert!(master.write(header(372, 2), Data::word(1_400)));
}

#[test]
fn eight_bits_and_no_parity_are_a_setting() {
    let mut master = Master::on(&format!("{ACU}data_bits = 8\nparity = \"none\""));
    assert_eq!(master.send(&hex(READ)), [0u8; 0]);
    assert_eq!(master.bench.totals().ignored.wrong_line, 1);
    master.line = LineSetting { data_bits: 8, parity: Parity::None, ..LINE };
    assert_eq!(master.read(header(372, 2)), word(1_390));
    master.is_innocent();
}

#[test]
fn the_line_carries_seven_bits() {
    let mut master = Master::on(ACU);
    let parity_left_in: Vec<u8> = hex(READ).iter().map(|byte| byte | 0x80).collect();
    assert!(!master.send(&parity_left_in).is_empty());
}

#[test]
fn chunks_of_one_telegram_and_an_eot_between_two() {
    let mut bench = Master::on(ACU).bench;
    let mut at = Tick::ZERO;
    for byte in [vec![EOT], hex(READ)].concat() {
        bench.master_sends(at, LINE, &[byte]);
        at = at + LINE.chars(1) + Span::from_millis(16);
    }
    let heard = bench.advance(at + Span::from_secs(1));
    assert_eq!((heard.len(), bench.remarks()), (15, &[][..]));
    bench.master_sends(at + Span::from_secs(1), LINE, &hex(READ)[..5]);
    assert!(bench.advance(at + Span::from_secs(2)).is_empty());
    assert_eq!(bench.remarks()[0].kind, Sin::Malformed);
    bench.master_sends(at + Span::from_secs(2), LINE, &hex(READ));
    assert_eq!(bench.advance(at + Span::from_secs(3)).len(), 15);
}

#[test]
fn too_early_too_impatient_too_often() {
    let mut bench = Master::on(ACU).bench;
    let mut at = Tick::ZERO;
    let absent = hex("04 5E 30 32 33 37 32 05");
    for (bytes, wait) in [(hex(READ), 30), (hex(READ), 26), (absent.clone(), 100), (hex(READ), 1_000)] {
        bench.master_sends(at, LINE, &bytes);
        at += Span::from_millis(wait);
        bench.advance(at);
    }
    let sins = |bench: &Bench| bench.remarks().iter().map(|remark| remark.kind).collect::<Vec<_>>();
    assert_eq!(sins(&bench), [Sin::Impatient]);
    // 8 characters, 10 ms, 15 characters: the reply ends 21.98 ms after the request began.
    bench.master_sends(at, LINE, &hex(READ));
    bench.advance(at + Span::from_millis(23));
    bench.master_sends(at + Span::from_millis(23), LINE, &hex(READ));
    assert_eq!(sins(&bench)[1..], [Sin::TooEarly]);
    at += Span::from_secs(1);
    let end = vec![EOT];
    for bytes in [&absent, &absent, &absent, &end, &absent, &absent, &absent, &absent] {
        bench.advance(at);
        bench.master_sends(at, LINE, bytes);
        at += Span::from_secs(1);
    }
    bench.advance(at);
    assert_eq!(sins(&bench)[2..], [Sin::TooOften]);
}

#[test]
fn disturbances_of_the_line() {
    let heard = |kind: &str| {
        let mut master = Master::on(&format!("{ACU}[[disturb]]\nonce = 1\nkind = \"{kind}\"\naddress = 1\n"));
        master.send(&hex(READ))
    };
    let reply = hex("41 02 30 32 33 37 32 30 34 30 35 36 45 03 45");
    assert_eq!(heard("foreign"), [&[0x42], &reply[1..]].concat());
    assert_eq!(heard("echo"), [hex(READ), reply.clone()].concat());
    assert_eq!(heard("doubled"), [reply.clone(), reply.clone()].concat());
    assert!(Reply::decode(&heard("garbled")).is_err() || heard("garbled")[0] != 0x41);
    assert_eq!(heard("truncated"), reply[..10]);
}

#[test]
fn the_watchdog_hears_vabus() {
    let mut master = Master::on(ACU);
    assert!(master.write(header(413, 0), Data::word(2)));
    assert_eq!(master.read(header(260, 0)), word(0));
    master.now += Span::from_secs(2);
    assert_eq!(master.read(header(260, 0)), word(0x2010));
}

#[test]
fn drives_and_judge_survive_anything() {
    let mut master = Master::on(CUBE);
    let mut dice = crate::simulator::dice::Dice::new(5);
    let pieces = [EOT, 0x02, ETX, ENQ, b'A', b'`', b'Q', b'0', b'1', b'4', 0x15];
    for _ in 0..2_000 {
        let byte = |below: u64| if below < 11 { pieces[below as usize] } else { (below * 17) as u8 };
        let bytes: Vec<u8> = (0..dice.below(40)).map(|_| byte(dice.below(13))).collect();
        master.bench.master_sends(master.now, LINE, &bytes);
        master.now += Span::from_millis(dice.below(300));
        master.bench.advance(master.now);
    }
    master.now += Span::from_secs(2);
    master.bench.advance(master.now);
    assert!(master.bench.totals().received > 100);
}
