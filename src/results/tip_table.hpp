#pragma once

#include <string>
#include <vector>

#include "results/tip_record.hpp"

namespace bempd::results {

// Writes a line for every record. Throws Error (io).
void write_tips(const std::string& path, const std::vector<TipRecord>& records);

}  // namespace bempd::results
