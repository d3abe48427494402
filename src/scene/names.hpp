#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

namespace bempd::scene {

// Names that the host gave to regions, edges, supports and loads, by their numbers. Messages of the library contain
// numbers, such as "region 2"; in() adds the names to a message, so that no message has to be written with names in
// mind.
class Names {
 public:
  enum class Kind { region, support, load };

  // Names a region, support or load; an empty name removes its name.
  void set(Kind kind, int number, std::string name) { put({static_cast<int>(kind), number, 0}, std::move(name)); }
  void set_edge(int region, int edge, std::string name) { put({of_edges, region, edge}, std::move(name)); }

  bool empty() const { return names_.empty(); }
  // Name of a region, support or load; empty if it has none.
  const std::string& of(Kind kind, int number) const { return at({static_cast<int>(kind), number, 0}); }
  const std::string& of_edge(int region, int edge) const { return at({of_edges, region, edge}); }
  // Numbers of the edges of a region that have this name; with an empty `name`, of all edges that have one.
  std::vector<int> edges(int region, const std::string& name = {}) const;

  // Kind, number and name of a region, support or load: region 2 ("middle").
  std::string called(Kind kind, int number) const;
  // Sentence with names added behind the numbers of regions, edges, supports and loads, alone or in a row: regions 1
  // ("left") and 2 ("middle"). An edge belongs to the region that follows it ("edge 3 of region 1"), else to the only
  // region in the sentence.
  std::string in(const std::string& sentence) const;

 private:
  using Key = std::array<int, 3>;
  static constexpr int of_edges = 3;

  void put(const Key& key, std::string name);
  const std::string& at(const Key& key) const;

  std::map<Key, std::string> names_;
};

}  // namespace bempd::scene
