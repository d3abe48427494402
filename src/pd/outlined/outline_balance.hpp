#pragma once

namespace bempd::pd {

// What the bonds near an outline are made for beside constant stress, which they carry exactly: nothing, or linear
// stress as nearly as weights near those of the kernel can.
enum class OutlineBalance { constant_stress, linear_stress };

}  // namespace bempd::pd
