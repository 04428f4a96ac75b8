//! From the command line, the environment and files (`low`: what was typed) to [`Settings`] (what holds), resolved once.

mod address;
pub mod below_zero;
mod bus;
mod choices;
mod globals;
mod low;
mod motion;
mod plant;
mod project;
mod settings;
mod takes;
mod warned;
mod wrong;

pub use address::{Addresses, parse_addresses, parse_place};
pub use bus::check_node;
pub use choices::{named_drives, named_groups, ports_there, usb_ports};
pub use globals::{Auto, ColorChoice, Globals, parse_span};
pub use low::{Environment, Origin, Typed, is_apart};
pub use motion::{KeypadArgs, MotionArgs, StopArg};
pub use plant::{
    Place, called, in_directory, letterhead, place, places, port_from_elsewhere, project_path, settings_of_plant,
    settings_over_lines, templates, typed_ports,
};
pub use project::{Letterhead, Template};
pub use settings::{Settings, Unknown, language, user_config_directory};
pub use takes::{SETTINGS, Takes, Useless};
