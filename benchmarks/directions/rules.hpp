#pragma once

#include <memory>
#include <random>

#include "stress.hpp"

namespace directions {

// What breaks next, and at which load factor.
struct Event {
  double load = 0;
  struct Loss {
    int bond;
    double stiffness;
  };
  std::vector<Loss> losses;
  bool finished = false;  // nothing more, or the window's rim is reached
};

class Rule {
 public:
  virtual ~Rule() = default;
  virtual Event next() = 0;
  // What the event before has released at load factor one.
  virtual void released(double) {}
  // Tip of the crack's line where the rule keeps one.
  virtual const std::vector<Point>* line() const { return nullptr; }
};

struct Setting {
  std::string name;
  std::string rule = "stretch";
  double radius = 0;   // of averages, in horizons
  double mix = 1;      // share of the average in what a bond breaks by
  double scatter = 0;  // of the critical stretch, from bond to bond
  double even = 0;     // share of the way to critical stretches by which straight cuts cost the same in all directions
  int release = 0;     // 1: a bond breaks when that would release its own fracture energy
  int teeth = 1;       // of a softening bond
  double ductility = 1;  // stretch without force over stretch of the peak
  double step = 1;       // of a crack line, in spacings
  double look = 3;       // ahead, for the release of energy
  double smooth = 0, cone = 0, opening = 0.5, shear = 0.4, back = 0.9, inner = 0.5, outer = 2.5;
  int learn = 0;  // steps from whose released energy a line corrects its load factor
  std::string turn = "stress", load = "release";
};

std::unique_ptr<Rule> make_rule(const Setting& setting, const Body& body, Window& window, unsigned seed);

// Each file's own.
std::unique_ptr<Rule> bond_rule(const Setting& setting, const Body& body, Window& window, unsigned seed);
std::unique_ptr<Rule> facet_rule(const Setting& setting, const Body& body, Window& window);
std::unique_ptr<Rule> line_rule(const Setting& setting, const Body& body, Window& window);

}  // namespace directions
