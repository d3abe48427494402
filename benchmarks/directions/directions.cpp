#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <sstream>

#include "check.hpp"
#include "rules.hpp"

namespace directions {
namespace {

constexpr double half_height = 26, growth = 60;

struct Run {
  std::vector<Point> middles;             // of what broke
  std::vector<double> loads, spent, own;  // at each event: load factor, energy released, own energy of the bonds
  std::vector<double> reach, length;      // of the crack after it
  double seconds = 0;
};

// Whether the bond comes close to the end of the window.
bool at_rim(const Body& body, const Bond& bond, double width, bool is_strip) {
  const Point p =
      (body.points[static_cast<std::size_t>(bond.first)] + body.points[static_cast<std::size_t>(bond.second)]) / 2;
  return is_strip ? p.x() > 72 || (body.tip.x() == 0 && p.x() > growth) ||
                        std::abs(p.y() - body.tip.y()) > width - body.horizon
                  : p.norm() > 20 - body.horizon;
}

double length_of(const std::vector<Point>& line) {
  double length = 0;
  for (std::size_t k = 2; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  return length;
}

Run follow(const Setting& setting, const Layout& layout, const Body& body, Window window, bool is_strip,
           std::vector<Point>& line) {
  Run run;
  const auto begin = std::chrono::steady_clock::now();
  const std::unique_ptr<Rule> rule = make_rule(setting, body, window, layout.seed);
  double reach = 0;
  for (int events = 0; events < 60000; ++events) {
    const Event event = rule->next();
    if (event.finished) break;
    double spent = 0, own = 0;
    bool rim = false;
    for (const Event::Loss& loss : event.losses) {
      const Bond& bond = body.bonds[static_cast<std::size_t>(loss.bond)];
      rim |= at_rim(body, bond, layout.width, is_strip);
      const double e = window.elongation(loss.bond);
      own += loss.stiffness * e * e / 2 * event.load * event.load;
      const double released = window.soften(loss.bond, loss.stiffness);
      if (released > 0) spent += released * event.load * event.load;
      if (released < 0) window.forget(loss.bond);
      const Point p =
          (body.points[static_cast<std::size_t>(bond.first)] + body.points[static_cast<std::size_t>(bond.second)]) / 2;
      if (window.stiffness(loss.bond) <= 0)
        run.middles.push_back(p), reach = std::max(reach, is_strip ? p.x() : p.norm());
    }
    rule->released(spent / (event.load * event.load));
    run.loads.push_back(event.load);
    run.spent.push_back(spent);
    run.own.push_back(own);
    run.reach.push_back(reach);
    run.length.push_back(rule->line() ? length_of(*rule->line()) : reach);
    if (rim) break;
  }
  if (rule->line()) line = *rule->line();
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return run;
}

double slope(const std::vector<Point>& points, double from, double to) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Point& p : points)
    if (p.x() >= from && p.x() <= to) n += 1, x += p.x(), y += p.y(), xx += p.x() * p.x(), xy += p.x() * p.y();
  return std::atan((n * xy - x * y) / (n * xx - x * x)) * 180 / std::numbers::pi;
}

// Through the origin, where the crack began.
double mean_direction(const std::vector<Point>& points, double from, double to) {
  Point sum(0, 0);
  for (const Point& p : points)
    if (p.norm() >= from && p.norm() <= to) sum += p;
  return std::atan2(sum.y(), sum.x()) * 180 / std::numbers::pi;
}

void report(const Setting& setting, const Layout& layout, const Body& body, const Run& run, bool has_line, double mode,
            bool is_strip) {
  const double end = run.reach.empty() ? 0 : run.reach.back();
  const double from = is_strip ? 6 : 3, to = is_strip ? end - 1 : std::min(end, 14.0);
  double spent = 0, own = 0, peak = 0, length_from = 0, length_to = 0;
  for (std::size_t k = 0; k < run.loads.size(); ++k) {
    if (run.reach[k] < 6) {
      length_from = run.length[k];
      continue;
    }
    spent += run.spent[k], own += run.own[k];
    length_to = run.length[k];
    if (run.reach[k] < to) peak = std::max(peak, run.loads[k] * run.loads[k] * body.release);
  }
  const double direction = is_strip ? slope(run.middles, from, to) : mean_direction(run.middles, from, to);
  const double length =
      (length_to - length_from) / std::cos(is_strip && !has_line ? direction * std::numbers::pi / 180 : 0);
  std::printf("%s,%d,%g,%g,%u,%.2f,%.1f,%.4f,%.4f,%.4f,%.4f,%zu,%.2f\n", setting.name.c_str(), layout.horizon,
              layout.angle, mode, layout.seed, direction, end,
              run.loads.empty() ? 0 : run.loads[0] * std::sqrt(body.release), peak, spent / length, own / length,
              run.loads.size(), run.seconds);
  std::fflush(stdout);
}

Setting parse(const std::string& text) {
  static const std::map<std::string, double Setting::*> numbers = {
      {"radius", &Setting::radius}, {"mix", &Setting::mix},         {"scatter", &Setting::scatter},
      {"even", &Setting::even},     {"step", &Setting::step},       {"ductility", &Setting::ductility},
      {"look", &Setting::look},     {"smooth", &Setting::smooth},   {"cone", &Setting::cone},
      {"shear", &Setting::shear},   {"opening", &Setting::opening}, {"inner", &Setting::inner},
      {"outer", &Setting::outer},   {"back", &Setting::back}};
  static const std::map<std::string, int Setting::*> counts = {
      {"teeth", &Setting::teeth}, {"learn", &Setting::learn}, {"release", &Setting::release}};
  static const std::map<std::string, std::string Setting::*> words = {
      {"turn", &Setting::turn}, {"load", &Setting::load}, {"name", &Setting::name}};
  Setting s;
  std::stringstream in(text);
  std::string item;
  s.name = text;
  std::getline(in, s.rule, ':');
  while (std::getline(in, item, ':')) {
    const std::string key = item.substr(0, item.find('=')), value = item.substr(item.find('=') + 1);
    if (numbers.count(key))
      s.*numbers.at(key) = std::atof(value.c_str());
    else if (counts.count(key))
      s.*counts.at(key) = std::atoi(value.c_str());
    else if (words.count(key))
      s.*words.at(key) = value;
    else
      throw std::runtime_error("no setting " + key);
  }
  return s;
}

}  // namespace
}  // namespace directions

// bempd_directions check
// bempd_directions strip|narrow|disc|plate m angle mode seed points kernel paths-file rule...
//   points: lattice, jitter=0.3, lloyd=4
int main(int count, char** argument) {
  using namespace directions;
  Layout layout;
  const std::string scene = argument[1];
  if (scene == "check") return check();
  const bool is_strip = scene != "disc";
  layout.horizon = std::atoi(argument[2]);
  layout.angle = std::atof(argument[3]);
  const double mode = std::atof(argument[4]);
  layout.seed = static_cast<unsigned>(std::atoi(argument[5]));
  const std::string points = argument[6];
  if (points.rfind("jitter=", 0) == 0) layout.jitter = std::atof(points.c_str() + 7);
  if (points.rfind("lloyd=", 0) == 0) layout.relaxation = std::atoi(points.c_str() + 6);
  layout.kernel = argument[7];
  if (scene == "narrow") layout.width = 4 + layout.horizon;
  const auto begin = std::chrono::steady_clock::now();
  Body body = scene == "plate" ? plate(layout, 80, mode)
              : is_strip       ? strip(layout, half_height, growth)
                               : disc(layout, 45, mode);
  if (is_strip && scene != "plate") body.release = strip_release(layout, half_height, growth);
  const Window window(body);
  std::fprintf(stderr, "prepared in %.2f s: %zu points, %zu in the window\n",
               std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(), body.points.size(),
               window.points().size());
  std::ofstream paths(argument[8], std::ios::app);
  for (int k = 9; k < count; ++k) {
    const Setting setting = parse(argument[k]);
    std::vector<Point> line;
    const Run run = follow(setting, layout, body, window, is_strip, line);
    report(setting, layout, body, run, !line.empty(), mode, is_strip);
    paths << setting.name << ' ' << points << ' ' << layout.kernel << ' ' << layout.horizon << ' ' << layout.angle
          << ' ' << mode << ' ' << layout.seed;
    for (const Point& p : line.empty() ? run.middles : line) paths << ' ' << p.x() << ' ' << p.y();
    paths << '\n';
  }
}
