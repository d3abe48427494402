#pragma once

namespace bempd::pd {

// Goal of the bonds near an outline besides constant stress, which they carry exactly: none, or linear stress as nearly
// as weights near those of the kernel can.
enum class OutlineBalance { constant_stress, linear_stress };

}  // namespace bempd::pd
