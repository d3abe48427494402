#pragma once

#include <string>
#include <vector>

#include "results/tip_record.hpp"

namespace bempd::results {

// Writes the records of tips as a CSV table, a line per record. Throws Error (io).
void write_tips(const std::string& path, const std::vector<TipRecord>& records);

}  // namespace bempd::results
