#include <cmath>
#include <numbers>

#include "rules.hpp"
#include "williams.hpp"

namespace directions {
namespace {

// The crack is a line that grows by a step at a time and cuts all bonds it meets, whatever the lattice.
class LineRule final : public Rule {
 public:
  LineRule(const Setting& setting, const Body& body, Window& window)
      : setting_(setting),
        body_(body),
        window_(window),
        mean_(body, window, setting.smooth * body.horizon),
        line_{body.tip + 10 * (body.crack_begin - body.tip).normalized(), body.tip} {}

  void released(double energy) override {
    lengths_.push_back((line_[line_.size() - 1] - line_[line_.size() - 2]).norm());
    spent_.push_back(energy * guess_ * guess_);
  }

  const std::vector<Point>* line() const override { return &line_; }

  Event next() override {
    const Point direction = turned();
    const Point tip = line_.back();
    Event event;
    for (double reach = setting_.step; reach < 4 && event.losses.empty(); reach += setting_.step) {
      event = {};
      for (const int k : across(tip, tip + reach * direction)) event.losses.push_back({k, window_.stiffness(k)});
      guess_ = load(tip, direction);
      event.load = corrected(guess_);
      line_.resize(before_);
      line_.push_back(tip + reach * direction);
    }
    ++before_;
    event.finished = event.losses.empty();
    return event;
  }

 private:
  Point tangent() const {
    // Over the last horizon of the line.
    Point from = line_.front();
    for (std::size_t k = line_.size(); k-- > 0;)
      if ((line_.back() - line_[k]).norm() >= setting_.back) {
        from = line_[k];
        break;
      }
    return (line_.back() - from).normalized();
  }

  // The energy that the last steps would have taken at the guessed load factors is what their length costs.
  double corrected(double guess) const {
    double length = 2, spent = 2;  // as if two spacings had been guessed well
    for (std::size_t k = lengths_.size(); k-- > 0 && lengths_.size() - k <= static_cast<std::size_t>(setting_.learn);)
      length += lengths_[k], spent += spent_[k];
    return guess * std::sqrt(length / spent);
  }

  std::vector<int> across(const Point& begin, const Point& end) const {
    std::vector<int> found;
    for (const int k : window_.bonds()) {
      const Bond& bond = body_.bonds[static_cast<std::size_t>(k)];
      if (window_.stiffness(k) > 0 && crosses(body_.points[static_cast<std::size_t>(bond.first)],
                                              body_.points[static_cast<std::size_t>(bond.second)], begin, end))
        found.push_back(k);
    }
    return found;
  }

  Intensity intensity(const Point& tip, const Point& direction) const {
    return fit_williams(body_, window_, tip, direction, 0.7 * body_.horizon, setting_.radius * body_.horizon);
  }

  // From the mean stress of points ahead: the opening part grows with the first intensity, the shear with the second.
  Intensity ahead(const Point& tip, const Point& along) {
    mean_.update();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double total = 0;
    for (const int point : window_.points()) {
      const Point p = body_.points[static_cast<std::size_t>(point)] - tip;
      const double ratio = p.norm() / (setting_.radius * body_.horizon);
      if (ratio >= 1 || p.dot(along) < setting_.cone * p.norm()) continue;
      const double weight = (1 - ratio * ratio) * (1 - ratio * ratio);
      sum += weight * mean_.at(point);
      total += weight;
    }
    sum /= total;
    const Point side(-along.y(), along.x());
    const auto part = [&](const Point& a, const Point& b) {
      return a.x() * b.x() * sum[0] + a.y() * b.y() * sum[1] + (a.x() * b.y() + a.y() * b.x()) * sum[2];
    };
    const double scale = std::sqrt(setting_.radius * body_.horizon);
    return {part(side, side) * scale / setting_.opening, part(along, side) * scale / setting_.shear};
  }

  Intensity field(const Point& tip, const Point& along) {
    mean_.update();
    return fit_stresses(body_, window_, mean_, tip, along, setting_.inner * body_.horizon,
                        setting_.outer * body_.horizon);
  }

  double load(const Point& tip, const Point& direction) {
    if (setting_.load == "ahead") return std::sqrt(8.0 / 9) / hoop_intensity(ahead(tip, tangent()));
    if (setting_.load == "williams") return std::sqrt(8.0 / 9) / hoop_intensity(intensity(tip, tangent()));
    if (setting_.load == "field") return std::sqrt(8.0 / 9) / hoop_intensity(field(tip, tangent()));
    return std::sqrt(setting_.look / window_.release_of(across(tip, tip + setting_.look * direction)));
  }

  Point turned() {
    const Point tip = line_.back(), along = tangent();
    const double angle = std::atan2(along.y(), along.x());
    double kink = 0;
    if (setting_.turn == "williams") kink = hoop_angle(intensity(tip, along));
    if (setting_.turn == "ahead") kink = hoop_angle(ahead(tip, along));
    if (setting_.turn == "field") kink = hoop_angle(field(tip, along));
    if (setting_.turn == "stress") {
      mean_.update();
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const int point : window_.points()) {
        const Point p = body_.points[static_cast<std::size_t>(point)] - tip;
        const double ratio = p.norm() / (setting_.radius * body_.horizon);
        if (ratio < 1 && p.dot(along) > 0) sum += (1 - ratio * ratio) * (1 - ratio * ratio) * mean_.at(point);
      }
      Point next(-principal(sum).normal.y(), principal(sum).normal.x());
      if (next.dot(along) < 0) next = -next;
      kink = std::atan2(along.x() * next.y() - along.y() * next.x(), along.dot(next));
    }
    if (setting_.turn == "release") {
      double best = 0;
      for (int degrees = -40; degrees <= 40; degrees += 5) {
        const double a = angle + degrees * std::numbers::pi / 180;
        const double release = window_.release_of(across(tip, tip + setting_.look * Point(std::cos(a), std::sin(a))));
        if (release > best) best = release, kink = a - angle;
      }
    }
    return {std::cos(angle + kink), std::sin(angle + kink)};
  }

  const Setting& setting_;
  const Body& body_;
  Window& window_;
  MeanStress mean_;
  std::vector<Point> line_;
  std::size_t before_ = 2;
  double guess_ = 0;
  std::vector<double> lengths_, spent_;  // of the steps so far; spent: at the guessed load factors
};

}  // namespace

std::unique_ptr<Rule> line_rule(const Setting& setting, const Body& body, Window& window) {
  return std::make_unique<LineRule>(setting, body, window);
}

}  // namespace directions
