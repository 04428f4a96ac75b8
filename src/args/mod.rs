//! From the command line, the environment and files to [`Settings`], resolved once.

mod globals;
mod motion;
mod settings;

pub use globals::{Auto, ColorChoice, Globals, parse_span};
pub use motion::{MotionArgs, StopArg};
pub use settings::{Addresses, Environment, Settings, Unknown, parse_addresses, user_config_directory};
