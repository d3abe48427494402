#pragma once

namespace bempd::pd {

// Goal for the bonds near an outline. They carry constant stress exactly. With linear_stress they also carry linear
// stress, as nearly as is possible with stiffnesses close to those that the peridynamic kernel gives.
enum class OutlineBalance { constant_stress, linear_stress };

}  // namespace bempd::pd
