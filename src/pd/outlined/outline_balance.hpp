#pragma once

namespace bempd::pd {

// Goal for the bonds near an outline besides constant stress, which they carry exactly: none, or to carry linear stress
// as nearly as stiffnesses close to the kernel's can.
enum class OutlineBalance { constant_stress, linear_stress };

}  // namespace bempd::pd
