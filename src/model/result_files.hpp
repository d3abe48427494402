#pragma once

#include <string>

#include "results/snapshots.hpp"

namespace bempd::model {

class Model;

// Result files of a model.
class ResultFiles {
 public:
  explicit ResultFiles(Model& model) : model_(model) {}

  void write_snapshot(const std::string& prefix);
  void write_history(const std::string& path) const;
  void write_tips(const std::string& path) const;

 private:
  Model& model_;
  results::Snapshots snapshots_;
};

}  // namespace bempd::model
