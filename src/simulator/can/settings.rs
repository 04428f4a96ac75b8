//! What a node's parameters make of its PDOs and of SYNC (EM-RES-03 manual 5.8.2, 5.9.2, 5.11; the numbers are those of 7.2).

use super::readings::{Reading, Readings};
use crate::protocol::can::pdo::{Kind, Place};
use crate::protocol::can::{PdoNumber, Service};
use crate::simulator::device::contract::Device;
use crate::tick::Span;

/// When a PDO goes out, or what came is handed on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    Off,
    Time,
    Sync,
}

/// A PDO that is sent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Tx {
    pub(super) identifier: u16,
    pub(super) function: Function,
    pub(super) every: Option<Span>,
    /// Which source fills which place, in the order of parameters.
    pub(super) inputs: Vec<(Place, u16)>,
}

/// A PDO that is received.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Rx {
    pub(super) number: PdoNumber,
    pub(super) identifier: u16,
    pub(super) function: Function,
    pub(super) timeout: Option<Span>,
}

/// All of it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Settings {
    pub(super) sync: u16,
    pub(super) sync_timeout: Option<Span>,
    pub(super) tx: Vec<Tx>,
    pub(super) rx: Vec<Rx>,
}

/// Inputs of the TxPDOs: the first boolean, word and long of each (manual 5.11.5.1). There is no 970 and 971.
const INPUTS: [[u32; 3]; 3] = [[946, 950, 954], [956, 960, 964], [966, 972, 976]];
/// Time-outs of the RxPDOs (manual 5.11.3). There is no 943 and 944.
const TIMEOUTS: [u32; 3] = [941, 942, 945];
const SYNC_IDENTIFIER: u32 = 918;
const SYNC_TIMEOUT: u32 = 939;
/// Sources that leave a place unused: of a boolean, and of the others.
const FALSE: u16 = 7;
const ZERO: u16 = 9;

impl Settings {
    /// As they stand in a drive with this node.
    pub(super) fn of(device: &dyn Device, node: u8, readings: Readings) -> Self {
        let value = |number: u32| device.ram(number, 0).unwrap_or(0);
        let number = |param: u32| u16::try_from(value(param)).unwrap_or(0);
        let span =
            |param: u32| Some(Span::from_millis(u64::try_from(value(param)).ok()?)).filter(|span| *span > Span::ZERO);
        let own = |param: u32, usual: Service| Some(number(param)).filter(|own| *own != 0).or(usual.identifier());
        let tx = |pdo: PdoNumber| {
            let index = u32::from(pdo.index());
            Tx {
                identifier: own(925 + 2 * index, Service::TxPdo(pdo, node)).unwrap_or(0),
                function: function(value(930 + 2 * index), true),
                every: span(931 + 2 * index)
                    .or((!readings.has(Reading::ZeroTimeIsSilent)).then_some(Span::from_millis(1))),
                inputs: Place::all().map(|place| (place, number(input(pdo, place)))).filter(used(readings)).collect(),
            }
        };
        let rx = |pdo: PdoNumber| {
            let index = u32::from(pdo.index());
            Rx {
                number: pdo,
                identifier: own(924 + 2 * index, Service::RxPdo(pdo, node)).unwrap_or(0),
                function: function(value(936 + index), readings.has(Reading::RxCountsFromOff)),
                timeout: TIMEOUTS.get(usize::from(pdo.index())).and_then(|param| span(*param)),
            }
        };
        Settings {
            sync: own(SYNC_IDENTIFIER, Service::Sync).unwrap_or(0),
            sync_timeout: span(SYNC_TIMEOUT),
            tx: PdoNumber::ALL.map(tx).into(),
            rx: PdoNumber::ALL.map(rx).into(),
        }
    }

    /// Whether anything waits for SYNC; only then it is watched (manual 5.11.3).
    pub(super) fn uses_sync(&self) -> bool {
        let functions = self.tx.iter().map(|tx| tx.function).chain(self.rx.iter().map(|rx| rx.function));
        functions.into_iter().any(|function| function == Function::Sync)
    }
}

/// What a code means: with an off before it (manual 5.7.2), or without (5.11.2).
fn function(code: i64, from_off: bool) -> Function {
    match code + i64::from(!from_off) {
        1 => Function::Time,
        2 => Function::Sync,
        _ => Function::Off,
    }
}

/// The parameter of a place of a TxPDO.
fn input(pdo: PdoNumber, place: Place) -> u32 {
    let of_kind = match place.kind() {
        Kind::Boolean => 0,
        Kind::Word => 1,
        Kind::Long => 2,
    };
    let firsts = INPUTS.get(usize::from(pdo.index()));
    firsts.and_then(|firsts| firsts.get(of_kind)).map_or(0, |first| first + u32::from(place.index()))
}

/// Whether a drive does not take a value for one of these parameters, whatever its range.
pub(super) fn refuses(device: &dyn Device, readings: Readings, param: u32, value: u32) -> bool {
    match param {
        918 | 921 | 922 | 924..=929 => readings.has(Reading::IdentifiersAreChecked) && (129..=191).contains(&value),
        931 | 933 | 935 => {
            value == 0 && !readings.has(Reading::ZeroTimeIsEveryMs) && !readings.has(Reading::ZeroTimeIsSilent)
        }
        936..=938 => value > 1 + u32::from(readings.has(Reading::RxCountsFromOff)),
        _ => readings.has(Reading::SharedByteIsRefused) && shares(device, readings, param, value),
    }
}

/// Whether an input would fill a byte that another one fills already.
fn shares(device: &dyn Device, readings: Readings, param: u32, value: u32) -> bool {
    let mut all = PdoNumber::ALL.into_iter().flat_map(|pdo| Place::all().map(move |place| (pdo, place)));
    let Some((pdo, place)) = all.find(|row| input(row.0, row.1) == param) else { return false };
    let fills = used(readings);
    let stands = |other: &Place| {
        let source = device.ram(input(pdo, *other), 0).and_then(|source| u16::try_from(source).ok());
        source.is_some_and(|source| fills(&(*other, source)))
    };
    let source = u16::try_from(value).unwrap_or(u16::MAX);
    fills(&(place, source)) && Place::all().any(|other| other != place && other.meets(place) && stands(&other))
}

/// Whether an input fills its place.
fn used(readings: Readings) -> impl Fn(&(Place, u16)) -> bool {
    move |(place, source)| {
        let (own, other) = if place.kind() == Kind::Boolean { (FALSE, ZERO) } else { (ZERO, FALSE) };
        *source != own && !(*source == other && readings.has(Reading::EitherZeroIsUnused))
    }
}
