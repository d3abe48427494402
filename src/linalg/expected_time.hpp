#pragma once

namespace bempd::linalg {

// Seconds that long work will take on this machine, for a host that waits for its end: an estimate within a factor of
// two where no other program takes the processor. It is 0 where nobody hears of phases or the work is short. The rate
// of the machine is that of a small product or loop, which takes a millisecond at most and is measured each time.

// Time of a factorization by dense products, sparse (supernodal) or dense.
double expected_time_of_products(double operations);

// Time of a factorization entry by entry: additions of a multiple of one sparse column to another.
double expected_time_of_entries(double operations);

}  // namespace bempd::linalg
