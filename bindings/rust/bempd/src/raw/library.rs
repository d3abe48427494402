use bempd_sys as sys;

use super::handle::{check, constant_text};
use crate::{OptionInfo, OptionKind, Result};

pub(crate) fn version() -> &'static str {
    // SAFETY: the library gives a constant string.
    unsafe { constant_text(sys::bempd_version_string()) }
}

pub(crate) fn build_info() -> &'static str {
    // SAFETY: the library gives a constant string.
    unsafe { constant_text(sys::bempd_build_info()) }
}

pub(crate) fn options() -> Result<Vec<OptionInfo>> {
    let mut count = 0;
    // SAFETY: the place for the result is valid.
    check(unsafe { sys::bempd_option_count(&mut count) })?;
    (0..count).map(option).collect()
}

fn option(index: i64) -> Result<OptionInfo> {
    // SAFETY: numbers and pointers, for which zero is a value; the library's strings are constant.
    unsafe {
        let mut info: sys::bempd_option_info = std::mem::zeroed();
        check(sys::bempd_option_info_init(&mut info, std::mem::size_of_val(&info) as i64))?;
        check(sys::bempd_option_describe(index, &mut info))?;
        let kind = if info.kind == sys::BEMPD_OPTION_TEXT as i32 {
            let choices = constant_text(info.choices).split(" | ").collect();
            OptionKind::Text { default: constant_text(info.default_text), choices }
        } else {
            OptionKind::Number {
                default: info.default_value,
                minimum: info.minimum,
                maximum: info.maximum,
                whole: info.whole_number != 0,
            }
        };
        Ok(OptionInfo {
            name: constant_text(info.name),
            summary: constant_text(info.summary),
            unit: constant_text(info.unit),
            kind,
        })
    }
}
