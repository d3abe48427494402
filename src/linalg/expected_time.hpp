#pragma once

namespace bempd::linalg {

// Expected seconds of long work on this machine, for a host that waits for its end: an estimate within a factor of two
// if no other program takes the processor. The value is 0 if nobody listens to phases or the work is short. The speed
// of the machine is measured each time with a small product or loop, which takes a millisecond at most.

// Time of a factorization by dense products, sparse (supernodal) or dense.
double expected_time_of_products(double operations);

// Time of a factorization entry by entry: additions of a multiple of one sparse column to another.
double expected_time_of_entries(double operations);

}  // namespace bempd::linalg
