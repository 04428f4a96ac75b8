//! The services of DP by their access points (IEC 61158-6-3; fieldbus facts).

use super::control::{Control, Function};
use super::frame::Frame;

/// Rows: name in Rust, access point of the slave, name of the norm.
macro_rules! services {
    ($($row:ident $sap:literal $name:literal,)*) => {
        /// What a telegram is about.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Service {
            /// No access point: outputs to the slave, inputs from it.
            DataExchange,
            $(#[doc = $name] $row,)*
            /// The data link layer itself: status, ident, access points.
            Link,
            /// An access point that is not told here.
            Other(u8),
        }

        impl Service {
            /// The services that have an access point.
            pub const ALL: &[Service] = &[$(Service::$row),*];

            fn of_sap(sap: u8) -> Self {
                match sap { $($sap => Service::$row,)* other => Service::Other(other) }
            }

            /// The access point of the slave; `None` for those that need none.
            pub fn sap(self) -> Option<u8> {
                match self {
                    $(Service::$row => Some($sap),)*
                    Service::Other(sap) => Some(sap),
                    Service::DataExchange | Service::Link => None,
                }
            }

            /// The name of the norm; empty where there is none.
            pub fn name(self) -> &'static str {
                match self {
                    Service::DataExchange => "Data_Exchange",
                    $(Service::$row => $name,)*
                    Service::Link => "FDL",
                    Service::Other(_) => "",
                }
            }
        }
    };
}

services! {
    ResourceManager 49 "Resource_Manager",
    Alarm 50 "Alarm",
    Acyclic 51 "MS1",
    ExtUserPrm 53 "Ext_User_Prm",
    SetSlaveAdd 55 "Set_Slave_Add",
    RdInp 56 "RD_Inp",
    RdOutp 57 "RD_Outp",
    GlobalControl 58 "Global_Control",
    GetCfg 59 "Get_Cfg",
    SlaveDiag 60 "Slave_Diag",
    SetPrm 61 "Set_Prm",
    ChkCfg 62 "Chk_Cfg",
}

impl Service {
    /// What a frame is about: the slave's access point tells, which a question has as its goal and an answer as its source.
    pub fn of(frame: &Frame) -> Self {
        let (slave, function) = match frame.control {
            Control::Request { function, .. } => (frame.dsap, Some(function)),
            Control::Reply { .. } => (frame.ssap, None),
        };
        match (slave, function) {
            (Some(sap), _) => Service::of_sap(sap),
            (None, Some(Function::FdlStatus | Function::Ident | Function::LsapStatus)) => Service::Link,
            (None, None) if frame.data.is_empty() => Service::Link,
            (None, _) => Service::DataExchange,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::dp::Telegram;

    #[test]
    fn a_question_and_its_answer_are_about_the_same() {
        let service = |bytes: &[u8]| match Telegram::decode(bytes).unwrap() {
            Telegram::Frame(frame) => Service::of(&frame),
            other => panic!("{other:?}"),
        };
        let asks = [0x68, 5, 5, 0x68, 0x88, 0x82, 0x6D, 0x3C, 0x3E, 0xF1, 0x16];
        let says = [0x68, 0x0B, 0x0B, 0x68, 0x82, 0x88, 8, 0x3E, 0x3C, 2, 5, 0, 0xFF, 0x0A, 0x35, 0xD1, 0x16];
        assert_eq!([service(&asks), service(&says)], [Service::SlaveDiag; 2]);
        assert_eq!(service(&[0x10, 8, 2, 0x49, 0x53, 0x16]), Service::Link);
        // Without an access point data are those of the exchange, and none are of the link.
        assert_eq!(service(&[0x68, 4, 4, 0x68, 2, 3, 8, 0x55, 0x62, 0x16]), Service::DataExchange);
        assert_eq!(service(&[0x10, 2, 3, 0, 5, 0x16]), Service::Link);
        assert!(Service::ALL.iter().all(|service| service.sap().map(Service::of_sap) == Some(*service)));
    }
}
