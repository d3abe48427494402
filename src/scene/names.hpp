#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bempd::scene {

// Names that the host gave to regions, edges, supports and loads, by their numbers. Sentences of the library speak of
// "region 2"; in() adds the names to them, so that no sentence has to be written with names in mind.
class Names {
 public:
  enum class Kind { region, support, load };

  // Names a thing; an empty name takes its name away.
  void set(Kind kind, int number, std::string name) { put({static_cast<int>(kind), number, 0}, std::move(name)); }
  void set_edge(int region, int edge, std::string name) { put({of_edges, region, edge}, std::move(name)); }

  bool empty() const { return names_.empty(); }
  // The name; empty if there is none.
  const std::string& of(Kind kind, int number) const { return at({static_cast<int>(kind), number, 0}); }
  const std::string& of_edge(int region, int edge) const { return at({of_edges, region, edge}); }
  // Numbers of the edges of a region that have this name, or any name if it is empty.
  std::vector<int> edges(int region, const std::string& name = {}) const;

  // What a thing is called: region 2 ("middle").
  std::string called(Kind kind, int number) const;
  // A sentence with the names of what it speaks of by number, alone or in a row: regions 1 ("left") and 2 ("middle").
  // An edge belongs to the region behind it ("edge 3 of region 1"), else to the only one that the sentence speaks of.
  std::string in(const std::string& sentence) const;

 private:
  using Key = std::array<int, 3>;
  static constexpr int of_edges = 3;

  void put(const Key& key, std::string name);
  const std::string& at(const Key& key) const;

  std::map<Key, std::string> names_;
};

}  // namespace bempd::scene
