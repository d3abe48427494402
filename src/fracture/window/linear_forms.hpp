#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bempd::fracture {

// List of linear forms, each of which is the sum of weight * value[place] over any number of places. The elongation of
// a bond is a form with four places.
class LinearForms {
 public:
  struct Form {
    std::span<const int> place;
    std::span<const double> weight;
    std::size_t size() const { return place.size(); }
  };

  std::size_t size() const { return start_.size() - 1; }
  Form operator[](std::size_t form) const {
    const std::size_t count = start_[form + 1] - start_[form];
    return {{place_.data() + start_[form], count}, {weight_.data() + start_[form], count}};
  }

  // Adds a weight to the form that is being built; close() ends that form.
  void add(int place, double weight) {
    place_.push_back(place);
    weight_.push_back(weight);
  }
  void close() { start_.push_back(place_.size()); }

  void append(const LinearForms& others) {
    for (std::size_t f = 0; f < others.size(); ++f) {
      const Form form = others[f];
      place_.insert(place_.end(), form.place.begin(), form.place.end());
      weight_.insert(weight_.end(), form.weight.begin(), form.weight.end());
      close();
    }
  }

  // Keeps only the forms whose flag is set.
  void keep(const std::vector<char>& chosen) {
    std::size_t to = 0, entries = 0;
    for (std::size_t f = 0; f < chosen.size(); ++f) {
      if (!chosen[f]) continue;
      const std::size_t begin = start_[f], end = start_[f + 1];
      for (std::size_t e = begin; e < end; ++e, ++entries) {
        place_[entries] = place_[e];
        weight_[entries] = weight_[e];
      }
      start_[++to] = entries;
    }
    start_.resize(to + 1);
    place_.resize(entries);
    weight_.resize(entries);
  }

  void renumber(const std::vector<int>& place_after) {
    for (int& place : place_) place = place_after[place];
  }

 private:
  std::vector<std::size_t> start_{0};
  std::vector<int> place_;
  std::vector<double> weight_;
};

}  // namespace bempd::fracture
