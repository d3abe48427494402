#pragma once

#include <set>
#include <unordered_map>
#include <vector>

#include "linalg/adjacency.hpp"
#include "regions/lattice/bonded_region.hpp"

namespace bempd::regions {

// Material points of a body of several regions (its members), and the members that have each point. A point near a
// common edge may belong to several members.
class SharedPoints {
 public:
  static constexpr int nobody = -1;

  struct Member {
    BondedRegion* region;
    std::vector<int> points;  // number in the body of each of the region's points
    Point shift;              // grid coordinates of the body less those of the region
  };

  // `places` are those of the body's points in its grid coordinates. All regions must have numbered their nodes.
  SharedPoints(std::vector<Member> members, std::vector<Point> places);

  // Whether each point is the same node of the scene for all members that have the point.
  bool has_one_node_each() const { return one_node_each_; }
  const std::vector<Member>& members() const { return members_; }
  const Point& place(int point) const { return places_[static_cast<std::size_t>(point)]; }
  int node(int point) const { return nodes_[static_cast<std::size_t>(point)]; }
  // Number that a point of the body has in a member; `nobody` if the member does not have the point.
  int number_in(int member, int point) const;
  // First member that has both ends of a bond of the body; `nobody` if no member has both.
  int owner(const pd::Bond& bond) const;
  // Whether one member has both ends of a bond and no other member has either end.
  bool is_within_one(const pd::Bond& bond) const;
  // Members that have at least one end of a bond.
  std::set<int> members_at(const pd::Bond& bond) const;
  // Fracture energy at each point of the body, relative to that of the material. At a point of several members the
  // value of the first member counts; a member without values counts as 1. Empty if no member has values.
  std::vector<double> energy_shares() const;

 private:
  // Member that has a point of the body, and the number of the point in this member.
  struct Holder {
    int member, point;
  };

  std::vector<Member> members_;
  std::vector<Point> places_;
  std::vector<int> nodes_;  // number in the scene of each point's node
  std::vector<Holder> holders_;
  linalg::Adjacency holders_at_;  // holders of each point, in the order of members
  bool one_node_each_ = true;
};

// Bonds of a body of several regions (its members), distributed to the members.
class SharedBonds {
 public:
  // Adds the bonds to the scene's energy terms. The bonds between points of each member come first, member by member,
  // then the bonds between points of different members.
  SharedBonds(const SharedPoints& points, const pd::Network& network, const Preparation& preparation,
              const Contributions& contributions);

  // Number of a bond of the body in the scene.
  int term(int bond) const { return static_cast<int>(of_scene_[static_cast<std::size_t>(bond)]); }
  // Number that a point of the body has in a member. Points of other members are numbered behind the member's own
  // points.
  int number(int member, int point);
  // Gives a member its bonds, and the numbers of its cell squares (SceneBonds::squares).
  void give(int member, std::vector<int> squares);

 private:
  // Bonds of one member while they are collected.
  struct Part {
    pd::Network network;
    SceneBonds bonds;
    std::unordered_map<int, int> far;  // numbers of points that only other members have
  };

  void add(int member, std::size_t bond, bool listed);

  const SharedPoints& points_;
  const pd::Network& network_;
  std::vector<std::size_t> of_scene_;
  std::vector<Part> parts_;
};

}  // namespace bempd::regions
