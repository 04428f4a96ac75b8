//! `antrieb`: the commissioning tool for industrial drives on serial lines.
pub mod profile;
pub mod protocol;
pub mod tick;
