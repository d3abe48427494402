// The classical way to tear the plate of the speed table: bond-based peridynamics on the lattice, without a matrix.
//
//   bempd_explicit_pd N explicit [transits]   velocity Verlet; the first break comes after so many wave transits
//   bempd_explicit_pd N relaxation [residual] equilibrium by adaptive dynamic relaxation, all overstretched bonds
//                                             break at once, and again until the load must rise
//
// N x N points, spacing 1, E = 1, nu = 1/3, plane stress, density 1, horizon ratio 4, micromodulus falling linearly to
// the horizon, critical stretch 1e-3; end columns held and pulled apart, a central crack of 0.2 N rows. Bonds are kept
// by offset, so that every inner loop runs over contiguous points without branches. Stops when the pull has
// fallen to a fiftieth of its peak or no chain of bonds joins the two ends any more, or after 120 s, and prints a
// line of JSON.
#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <numeric>
#include <vector>

namespace {

using Values = std::vector<double>;
constexpr double critical_stretch = 1e-3, horizon = 4, seconds_allowed = 120, force_left = 0.02;

// Processor time: the program has one thread, and a busy machine counts less so.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// All bonds with one offset: stiffness per stretch and alive (1 or 0) for each first point, 0 where there is no bond.
struct Offset {
  int dx, dy;
  double length, nx, ny, stiffness;
  Values alive;
};

struct Plate {
  int n;
  std::vector<Offset> offsets;
  Values ux, uy, fx, fy, row;
  double diagonal = 0;  // largest sum of the bond stiffnesses at a point
  size_t at(int x, int y) const { return static_cast<size_t>(y) * n + x; }
};

// The stiffness makes the infinite lattice carry a uniaxial strain with the stress E / (1 - nu^2).
void calibrate(std::vector<Offset>& offsets) {
  double sum = 0;
  for (const Offset& o : offsets) sum += o.stiffness * o.length * std::pow(o.nx, 4);
  for (Offset& o : offsets) o.stiffness *= 9.0 / 8 / sum;
}

Plate make_plate(int n) {
  Plate plate{n, {}, Values(n * n), Values(n * n), Values(n * n), Values(n * n), Values(n)};
  const double rows = std::floor(0.2 * n), middle = 0.5 * (n - 1), crack = std::floor(middle) + 0.5;
  const double low = std::ceil(middle - 0.5 * rows) - 0.5, high = low + rows;
  for (int dy = 0; dy < horizon; ++dy) {
    for (int dx = -3; dx < horizon; ++dx) {
      const double length = std::hypot(dx, dy);
      if ((dy == 0 && dx <= 0) || length >= horizon) continue;
      plate.offsets.push_back({dx, dy, length, dx / length, dy / length, 1 - length / horizon, Values(n * n)});
    }
  }
  calibrate(plate.offsets);
  for (Offset& o : plate.offsets) {
    plate.diagonal += 2 * o.stiffness / o.length;
    for (int y = 0; y + o.dy < n; ++y) {
      for (int x = std::max(0, -o.dx); x < std::min(n, n - o.dx); ++x) {
        const double along = o.dx ? (crack - x) / o.dx : -1, meets = y + along * o.dy;
        o.alive[plate.at(x, y)] = !(along > 0 && along < 1 && meets > low && meets < high);
      }
    }
  }
  return plate;
}

// Internal forces; breaks what exceeds the limit; returns the largest stretch and counts the broken.
double internal_forces(Plate& p, double limit, long& broken) {
  std::fill(p.fx.begin(), p.fx.end(), 0.0);
  std::fill(p.fy.begin(), p.fy.end(), 0.0);
  double largest = 0, still = 0, before = 0;
  for (Offset& o : p.offsets) {
    const double cx = o.nx / o.length, cy = o.ny / o.length;
    for (int y = 0; y + o.dy < p.n; ++y) {
      const int first = std::max(0, -o.dx), count = p.n - std::abs(o.dx);
      const size_t i = p.at(first, y), j = p.at(first + o.dx, y + o.dy);
      const double *ui = &p.ux[i], *vi = &p.uy[i], *uj = &p.ux[j], *vj = &p.uy[j];
      double *fi = &p.fx[i], *gi = &p.fy[i], *fj = &p.fx[j], *gj = &p.fy[j], *alive = &o.alive[i];
      // The two ends of a row overlap: forces are kept, so that each loop is free of dependences.
      double* force = p.row.data();
      double row_largest = 0, row_before = 0, row_still = 0;
#pragma omp simd reduction(max : row_largest) reduction(+ : row_before, row_still)
      for (int k = 0; k < count; ++k) {
        const double stretch = alive[k] * (cx * (uj[k] - ui[k]) + cy * (vj[k] - vi[k]));
        row_before += alive[k];
        alive[k] = stretch > limit ? 0.0 : alive[k];
        row_still += alive[k];
        row_largest = stretch > row_largest ? stretch : row_largest;
        force[k] = alive[k] * o.stiffness * stretch;
      }
#pragma omp simd
      for (int k = 0; k < count; ++k) fi[k] += o.nx * force[k], gi[k] += o.ny * force[k];
#pragma omp simd
      for (int k = 0; k < count; ++k) fj[k] -= o.nx * force[k], gj[k] -= o.ny * force[k];
      largest = std::max(largest, row_largest), before += row_before, still += row_still;
    }
  }
  broken += std::lround(before - still);
  return largest;
}

double end_force(const Plate& p) {
  double sum = 0;
  for (int y = 0; y < p.n; ++y) sum += p.fx[p.at(0, y)];
  return sum;
}

bool joined(const Plate& p) {
  std::vector<size_t> root(p.ux.size());
  std::iota(root.begin(), root.end(), size_t{0});
  const auto find = [&](size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (int y = 1; y < p.n; ++y) root[p.at(0, y)] = p.at(0, 0), root[p.at(p.n - 1, y)] = p.at(p.n - 1, 0);
  for (const Offset& o : p.offsets) {
    const long step = static_cast<long>(o.dy) * p.n + o.dx;
    for (size_t i = 0; i < o.alive.size(); ++i) {
      if (o.alive[i] > 0) root[find(i)] = find(static_cast<size_t>(static_cast<long>(i) + step));
    }
  }
  return find(p.at(0, 0)) == find(p.at(p.n - 1, 0));
}

struct Outcome {
  long steps = 0, broken = 0;
  double peak = 0, opening = 0;
  bool finished = false;
};

void pull_ends(Plate& p, double opening) {
  for (int y = 0; y < p.n; ++y) p.ux[p.at(0, y)] = -opening, p.ux[p.at(p.n - 1, y)] = opening;
}

bool held(const Plate& p, size_t i) { return i % p.n == 0 || i % p.n == static_cast<size_t>(p.n) - 1; }

// Density 1; the largest frequency of the network is below sqrt(2 diagonal), waves travel at about sqrt(E / (1 -
// nu^2)).
Outcome run_explicit(Plate& p, double transits, double first_break, double start) {
  const double dt = 0.9 * 2 / std::sqrt(2 * p.diagonal), damping = 2 * 3.14159 / p.n * 0.3;
  const double rate = first_break / (transits * p.n / 1.06);
  Values vx(p.ux.size()), vy(p.ux.size());
  // Homogeneous stretching from the start, so that no shock runs in from the ends.
  for (size_t i = 0; i < vx.size(); ++i) vx[i] = rate * (2.0 * static_cast<double>(i % p.n) / (p.n - 1) - 1);
  Outcome out;
  double pull = 0;
  while (!out.finished && now() - start < seconds_allowed) {
    for (size_t i = 0; i < vx.size(); ++i) p.ux[i] += dt * vx[i], p.uy[i] += dt * vy[i];
    internal_forces(p, critical_stretch, out.broken);
    out.opening += rate * dt;
    out.peak = std::max(out.peak, end_force(p));
    // Averaged over a wave transit: the halves ring after the break.
    pull += (end_force(p) - pull) * dt * 1.06 / p.n;
    const double keep = (1 - 0.5 * damping * dt) / (1 + 0.5 * damping * dt), push = dt / (1 + 0.5 * damping * dt);
    for (int y = 0; y < p.n; ++y) {
      for (size_t i = p.at(1, y), end = p.at(p.n - 1, y); i < end; ++i) {
        vx[i] = keep * vx[i] + push * p.fx[i], vy[i] = keep * vy[i] + push * p.fy[i];
      }
    }
    if (++out.steps % 100 == 0 && out.broken > 0) out.finished = std::abs(pull) < force_left * out.peak || !joined(p);
  }
  return out;
}

// Adaptive dynamic relaxation after Underwood (1983) and Kilic and Madenci (2010): unit step, fictitious mass from the
// stiffness, damping from Rayleigh's quotient of the latest change.
bool relax(Plate& p, double tolerance, Outcome& out, double start) {
  double scale = 0;
  const double mass = 0.55 * p.diagonal;
  Values vx(p.ux.size()), vy(p.ux.size()), ox(p.ux.size()), oy(p.ux.size());
  for (long step = 0; now() - start < seconds_allowed; ++step, ++out.steps) {
    long none = 0;
    internal_forces(p, 1e300, none);
    double unbalanced = 0, change = 0, size = 0;
    for (size_t i = 0; i < vx.size(); ++i) {
      if (held(p, i)) {
        scale = std::max(scale, std::abs(p.fx[i]));
        continue;
      }
      unbalanced = std::max({unbalanced, std::abs(p.fx[i]), std::abs(p.fy[i])});
      change -= vx[i] * (p.fx[i] - ox[i]) + vy[i] * (p.fy[i] - oy[i]);
      size += mass * (vx[i] * vx[i] + vy[i] * vy[i]);
    }
    if (unbalanced <= tolerance * scale) return true;
    const double frequency = size > 0 && change > 0 ? std::sqrt(change / size) : 0;
    const double c = std::min(2 * frequency, 1.9);
    for (size_t i = 0; i < vx.size(); ++i) {
      ox[i] = p.fx[i], oy[i] = p.fy[i];
      if (held(p, i)) continue;
      vx[i] = ((2 - c) * vx[i] + 2 * p.fx[i] / mass) / (2 + c),
      vy[i] = ((2 - c) * vy[i] + 2 * p.fy[i] / mass) / (2 + c);
      p.ux[i] += vx[i], p.uy[i] += vy[i];
    }
  }
  return false;
}

// Opening at the first break; leaves the plate in equilibrium there.
double to_first_break(Plate& p, double tolerance, Outcome& out, double start) {
  for (size_t i = 0; i < p.ux.size(); ++i) p.ux[i] = 2.0 * static_cast<double>(i % p.n) / (p.n - 1) - 1;
  pull_ends(p, 1);
  relax(p, tolerance, out, start);
  long none = 0;
  const double opening = critical_stretch / internal_forces(p, 1e300, none);
  for (double& u : p.ux) u *= opening;
  for (double& u : p.uy) u *= opening;
  return opening;
}

// Runs by relaxation. All is proportional to the load between breaks, so the load rises to half a percent above the
// next break at once.
Outcome run_relaxation(Plate& p, double tolerance, double start) {
  Outcome out;
  out.opening = to_first_break(p, tolerance, out, start);
  while (relax(p, tolerance, out, start)) {
    out.peak = std::max(out.peak, end_force(p));
    long none = 0;
    const double largest = internal_forces(p, 1e300, none);
    if (largest <= critical_stretch * (1 + 1e-9)) {
      const double rise = 1.005 * critical_stretch / largest;
      for (double& u : p.ux) u *= rise;
      for (double& u : p.uy) u *= rise;
      out.opening *= rise;
    }
    internal_forces(p, critical_stretch, out.broken);
    if (end_force(p) < force_left * out.peak || !joined(p)) {
      out.finished = true;
      break;
    }
  }
  return out;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return EXIT_FAILURE;
#if defined(__SSE2__)
  // Denormal numbers are flushed to zero: they stand ahead of a wave, and processors are slow on them.
  _mm_setcsr(_mm_getcsr() | _MM_FLUSH_ZERO_ON | 0x40);
#endif
  const int n = std::atoi(arguments[1]);
  const bool in_time = std::strcmp(arguments[2], "explicit") == 0;
  Plate plate = make_plate(n);
  Outcome out;
  double start = now();
  if (in_time) {
    // What a user knows beforehand is not counted: about where the first break comes.
    Plate before = plate;
    Outcome ignored;
    const double first_break = to_first_break(before, 1e-3, ignored, start);
    start = now();
    out = run_explicit(plate, count > 3 ? std::atof(arguments[3]) : 20, first_break, start);
  } else {
    out = run_relaxation(plate, count > 3 ? std::atof(arguments[3]) : 1e-4, start);
  }
  std::printf(
      "{\"seconds\": %.4f, \"steps\": %ld, \"bonds\": %ld, \"peak_force\": %.6g, \"opening\": %.6g, "
      "\"finished\": %s}\n",
      now() - start, out.steps, out.broken, out.peak, out.opening, out.finished ? "true" : "false");
  return EXIT_SUCCESS;
}
