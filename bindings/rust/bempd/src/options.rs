use crate::{raw, Model, Result};

/// Description of one option.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct OptionInfo {
    /// Name for [`Model::set_option`] and its kin.
    pub name: &'static str,
    /// One sentence.
    pub summary: &'static str,
    /// Unit, "-" for a pure number.
    pub unit: &'static str,
    /// What the option takes.
    pub kind: OptionKind,
}

/// Whether an option takes a number or a word.
#[derive(Clone, Debug, PartialEq)]
pub enum OptionKind {
    /// A number.
    Number {
        /// Default value.
        default: f64,
        /// Smallest legal number.
        minimum: f64,
        /// Largest legal number.
        maximum: f64,
        /// Whether only whole numbers are legal.
        whole: bool,
    },
    /// A word.
    Text {
        /// Default word.
        default: &'static str,
        /// The legal words.
        choices: Vec<&'static str>,
    },
}

/// All options of this version of the library.
///
/// ```
/// for option in bempd::options()? {
///     println!("{}: {}", option.name, option.summary);
/// }
/// # Ok::<(), bempd::Error>(())
/// ```
pub fn options() -> Result<Vec<OptionInfo>> {
    raw::options()
}

/// # Options
///
/// Set them before or between steps; what a prepared model has built already keeps the old value.
impl Model {
    /// Sets a number option. The error for an unknown name lists the near ones.
    pub fn set_option(&mut self, name: &str, value: f64) -> Result<()> {
        self.handle.set_option(name, value)
    }

    /// Value of a number option.
    pub fn option(&self, name: &str) -> Result<f64> {
        self.handle.get_option(name)
    }

    /// Sets a text option to one of its choices.
    pub fn set_option_text(&mut self, name: &str, value: &str) -> Result<()> {
        self.handle.set_option_text(name, value)
    }

    /// Value of a text option.
    pub fn option_text(&self, name: &str) -> Result<String> {
        self.handle.get_option_text(name)
    }
}
