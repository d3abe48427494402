#include "bem/kernel_sums.hpp"

// The disabled warning concerns calls of functions with vector arguments; all such functions here are inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

#include "bem/lanes.hpp"

namespace bempd::bem {

namespace {

enum Kernel { logarithm, cosine, sine, along, across, along_cosine, along_sine, kernel_count };
constexpr int weak_count = 3, strong_count = 4;

using Row = ElementPoints::Values;  // one value per outer point

// Values of all kernels at all pairs of points: for every inner point a row with the outer points.
struct KernelTable {
  alignas(64) Row at[kernel_count][max_regular_points];
};

// Shape functions of the outer element: for every point the values of all nodes, side by side.
template <std::size_t points>
using NodeWeights = double[points][padded_nodes];

// Kernel sums for vectors of `lanes` numbers, a template so that they can be compiled for several instruction sets.
template <int lanes>
class Sums {
 public:
  using Values = typename Lanes<lanes>::Values;

  [[gnu::always_inline]] static void add(const ElementPoints& outer, const ElementPoints& inner, PairPart part,
                                         PairMoments& moments) {
    KernelTable table;
    evaluate(outer, inner, table);
    alignas(64) NodeWeights<max_regular_points> mass, derivative;
    gather(outer.count, outer.mass, mass);
    Row rows[6];
    for (int k = 0; k < strong_count && part != PairPart::derivative_only; ++k) {
      sum_inner(outer.count, inner.count, table.at[weak_count + k], inner.shape, rows);
      append_own_nodes(outer, rows);
      sum_outer(outer.count, rows, mass, &moments.double_layer[k][0]);
      sum_outer(outer.count, rows + 3, mass, &moments.double_layer[k][3]);
    }
    if (part == PairPart::double_layer_only) return;
    gather(outer.count, outer.derivative, derivative);
    for (int k = 0; k < weak_count; ++k) {
      if (part == PairPart::everything) {
        sum_inner(outer.count, inner.count, table.at[k], inner.mass, rows);
        sum_outer(outer.count, rows, mass, moments.mass[k].data());
      }
      sum_inner(outer.count, inner.count, table.at[k], inner.derivative, rows);
      sum_outer(outer.count, rows, derivative, moments.derivative[k].data());
      complete_block(moments.derivative[k]);
    }
  }

  [[gnu::always_inline]] static void add(const SingularPoints& points, PairPart part, PairMoments& moments) {
    SingularTable table;
    evaluate(points, table);
    if (points.outer_ignores_angle)
      add_by_rows(points, table, part, moments);
    else
      add_by_products(points, table, part, moments);
    for (PairMoments::Block& block : moments.derivative) complete_block(block);
  }

 private:
  using SingularRow = SingularPoints::Values;

  // Values of all kernels times quadrature weights: for every angle a row with one value per radius.
  struct SingularTable {
    SingularRow at[kernel_count][SingularPoints::most_angles];
  };

  [[gnu::always_inline]] static void evaluate(const SingularPoints& points, SingularTable& table) {
    for (int q = 0; q < points.angles; ++q) {
      const SingularPoints::Pair& pair = points.pairs[q];
      const SingularPoints::Side& inner = points.inner_at(q);
      for (int p = 0; p < points.radii; p += lanes) {
        const Values x = load<Values>(&pair.chord_x[p]), y = load<Values>(&pair.chord_y[p]);
        const Values nx = load<Values>(&inner.normal_x[p]), ny = load<Values>(&inner.normal_y[p]);
        const Values weight = load<Values>(&pair.weight[p]);
        const auto [ln, inverse] = half_logarithm_and_inverse<lanes>(x * x + y * y);
        const Values c = 0.5 * (x * x - y * y) * inverse, s = x * y * inverse;
        const Values weighted = weight * inverse, a = weighted * (nx * x + ny * y);
        store(Values(load<Values>(&pair.log_weight[p]) + weight * ln), &table.at[logarithm][q][p]);
        store(Values(weight * c), &table.at[cosine][q][p]);
        store(Values(weight * s), &table.at[sine][q][p]);
        store(a, &table.at[along][q][p]);
        store(Values(weighted * (nx * y - ny * x)), &table.at[across][q][p]);
        store(Values(a * c), &table.at[along_cosine][q][p]);
        store(Values(a * s), &table.at[along_sine][q][p]);
      }
    }
  }

  // Adds the integrals if each radius has a single outer point: values are first summed over the angles.
  [[gnu::always_inline]] static void add_by_rows(const SingularPoints& points, const SingularTable& table,
                                                 PairPart part, PairMoments& moments) {
    const SingularPoints::Side& outer = points.outer[0];
    alignas(64) NodeWeights<SingularPoints::most_radii> weights;
    SingularRow rows[6], bare;
    gather(points.radii, outer.mass, weights);
    for (int k = 0; k < strong_count && part != PairPart::derivative_only; ++k) {
      sum_angles(points, table.at[weak_count + k], &SingularPoints::Side::difference, rows, bare);
      for (int b = 0; b < 3; ++b)
        for (int p = 0; p < points.radii; p += lanes)
          store(Values(load<Values>(&bare[p]) * load<Values>(&outer.difference[b][p])), &rows[3 + b][p]);
      sum_outer(points.radii, rows, weights, &moments.double_layer[k][0]);
      sum_outer(points.radii, rows + 3, weights, &moments.double_layer[k][3]);
    }
    if (part == PairPart::double_layer_only) return;
    for (int k = 0; k < weak_count && part == PairPart::everything; ++k) {
      sum_angles(points, table.at[k], &SingularPoints::Side::mass, rows, bare);
      sum_outer(points.radii, rows, weights, moments.mass[k].data());
    }
    gather(points.radii, outer.derivative, weights);
    for (int k = 0; k < weak_count; ++k) {
      sum_angles(points, table.at[k], &SingularPoints::Side::derivative, rows, bare);
      sum_outer(points.radii, rows, weights, moments.derivative[k].data());
    }
  }

  using Functions = std::array<SingularRow, 3> SingularPoints::Side::*;

  // Sums over the angles the kernel times the inner element's three functions (`rows`), and the kernel alone (`bare`).
  [[gnu::always_inline]] static void sum_angles(const SingularPoints& points, const SingularRow* kernel,
                                                Functions functions, SingularRow* rows, SingularRow& bare) {
    for (int p = 0; p < points.radii; p += lanes) {
      Values sums[4]{};
      for (int q = 0; q < points.angles; ++q) {
        const Values value = load<Values>(&kernel[q][p]);
        const std::array<SingularRow, 3>& f = points.inner_at(q).*functions;
        for (int b = 0; b < 3; ++b) sums[b] += value * load<Values>(&f[b][p]);
        sums[3] += value;
      }
      for (int b = 0; b < 3; ++b) store(sums[b], &rows[b][p]);
      store(sums[3], &bare[p]);
    }
  }

  [[gnu::always_inline]] static void add_by_products(const SingularPoints& points, const SingularTable& table,
                                                     PairPart part, PairMoments& moments) {
    using Side = SingularPoints::Side;
    for (int b = 0; b < 3; ++b) {
      for (int k = 0; k < strong_count && part != PairPart::derivative_only; ++k) {
        const SingularRow* kernel = table.at[weak_count + k];
        PairMoments::WideBlock& block = moments.double_layer[k];
        add_products(points, kernel, &Side::mass, false, &Side::difference, b, block[b]);
        if (points.has_outer_part) add_products(points, kernel, &Side::mass, true, &Side::difference, b, block[3 + b]);
      }
      for (int k = 0; k < weak_count && part != PairPart::double_layer_only; ++k) {
        if (part == PairPart::everything)
          add_products(points, table.at[k], &Side::mass, false, &Side::mass, b, moments.mass[k][b]);
        if (b != 1)
          add_products(points, table.at[k], &Side::derivative, false, &Side::derivative, b, moments.derivative[k][b]);
      }
    }
  }

  // Sums over all points the kernel times the outer functions times function `b` of the inner (`own`: outer) element.
  [[gnu::always_inline]] static void add_products(const SingularPoints& points, const SingularRow* kernel,
                                                  Functions of_outer, bool own, Functions of_other, int b,
                                                  PairMoments::Column& column) {
    Values sums[3]{};
    for (int q = 0; q < points.angles; ++q) {
      const std::array<SingularRow, 3>& f = points.outer[q].*of_outer;
      const SingularPoints::Side* other = own ? &points.outer[q] : &points.inner_at(q);
      const SingularRow& g = (other->*of_other)[b];
      for (int p = 0; p < points.radii; p += lanes) {
        const Values value = load<Values>(&kernel[q][p]) * load<Values>(&g[p]);
        for (int a = 0; a < 3; ++a) sums[a] += value * load<Values>(&f[a][p]);
      }
    }
    for (int a = 0; a < 3; ++a)
      for (int lane = 0; lane < lanes; ++lane) column[a] += sums[a][lane];
  }

  // Makes rows and columns add to zero, as constants have no slope; this helps the accuracy of slender bodies.
  [[gnu::always_inline]] static void complete_block(PairMoments::Block& block) {
    for (int a = 0; a < padded_nodes; ++a) block[1][a] = -(block[0][a] + block[2][a]);
    for (PairMoments::Column& column : block) column[1] = -(column[0] + column[2]);
  }

  [[gnu::always_inline]] static void evaluate(const ElementPoints& outer, const ElementPoints& inner,
                                              KernelTable& table) {
    for (int q = 0; q < inner.count; ++q) {
      const double nx = inner.normal_x[q], ny = inner.normal_y[q];
      for (int p = 0; p < outer.count; p += lanes) {
        const Values rx = inner.x[q] - load<Values>(&outer.x[p]), ry = inner.y[q] - load<Values>(&outer.y[p]);
        const auto [ln, inverse] = half_logarithm_and_inverse<lanes>(rx * rx + ry * ry);
        const Values x = rx * inverse, y = ry * inverse;
        const Values c = 0.5 * (rx * x - ry * y), s = rx * y, a = nx * x + ny * y;
        store(ln, &table.at[logarithm][q][p]);
        store(c, &table.at[cosine][q][p]);
        store(s, &table.at[sine][q][p]);
        store(a, &table.at[along][q][p]);
        store(Values(nx * y - ny * x), &table.at[across][q][p]);
        store(Values(a * c), &table.at[along_cosine][q][p]);
        store(Values(a * s), &table.at[along_sine][q][p]);
      }
    }
  }

  // Three sums of vectors, each vector times a number.
  struct ThreeSums {
    Values a{}, b{}, c{};
    [[gnu::always_inline]] void add(double for_a, double for_b, double for_c, const Values& v) {
      a += for_a * v;
      b += for_b * v;
      c += for_c * v;
    }
    [[gnu::always_inline]] void store_in(Row* rows, int p) const {
      store(a, &rows[0][p]);
      store(b, &rows[1][p]);
      store(c, &rows[2][p]);
    }
  };

  // Sums the kernel times each of three functions `f` over the inner points: one row of outer points per function.
  [[gnu::always_inline]] static void sum_inner(int outer_count, int count, const Row (&kernel)[max_regular_points],
                                               const std::array<Row, 3>& f, Row* rows) {
    for (int p = 0; p < outer_count; p += 2 * lanes) {
      ThreeSums near, far;
      if (p + lanes < outer_count) {
        for (int q = 0; q < count; ++q) {
          near.add(f[0][q], f[1][q], f[2][q], load<Values>(&kernel[q][p]));
          far.add(f[0][q], f[1][q], f[2][q], load<Values>(&kernel[q][p + lanes]));
        }
        far.store_in(rows, p + lanes);
      } else {
        for (int q = 0; q < count; ++q) near.add(f[0][q], f[1][q], f[2][q], load<Values>(&kernel[q][p]));
      }
      near.store_in(rows, p);
    }
  }

  // Appends rows for the outer element's functions: minus the sum of the kernel alone times the outer shape functions.
  // The sum of the kernel alone is that of the first three rows, because the inner shape functions add to one.
  [[gnu::always_inline]] static void append_own_nodes(const ElementPoints& outer, Row* rows) {
    for (int p = 0; p < outer.count; p += lanes) {
      const Values minus_bare = -(load<Values>(&rows[0][p]) + load<Values>(&rows[1][p]) + load<Values>(&rows[2][p]));
      for (int b = 0; b < 3; ++b) store(Values(minus_bare * load<Values>(&outer.shape[b][p])), &rows[3 + b][p]);
    }
  }

  template <std::size_t points>
  [[gnu::always_inline]] static void gather(int count, const std::array<std::array<double, points>, 3>& functions,
                                            NodeWeights<points>& weights) {
    for (int p = 0; p < count; ++p) {
      double* weight = weights[p];
      weight[0] = functions[0][p], weight[1] = functions[1][p], weight[2] = functions[2][p], weight[3] = 0;
    }
  }

  // Sums each of three rows times the outer shape functions over the outer points; adds one column per row.
  template <std::size_t points>
  [[gnu::always_inline]] static void sum_outer(int count, const std::array<double, points>* rows,
                                               const NodeWeights<points>& weights, PairMoments::Column* columns) {
    for (int node = 0; node < padded_nodes; node += lanes) {
      ThreeSums sum;
      for (int p = 0; p < count; ++p) sum.add(rows[0][p], rows[1][p], rows[2][p], load<Values>(&weights[p][node]));
      store(Values(load<Values>(&columns[0][node]) + sum.a), &columns[0][node]);
      store(Values(load<Values>(&columns[1][node]) + sum.b), &columns[1][node]);
      store(Values(load<Values>(&columns[2][node]) + sum.c), &columns[2][node]);
    }
  }
};

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] void add_with_avx2(const ElementPoints& outer, const ElementPoints& inner, PairPart part,
                                               PairMoments& moments) {
  Sums<4>::add(outer, inner, part, moments);
}
[[gnu::target("avx2,fma")]] void add_with_avx2(const SingularPoints& points, PairPart part, PairMoments& moments) {
  Sums<4>::add(points, part, moments);
}
const bool has_avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif

}  // namespace

void add_kernel_sums(const ElementPoints& outer, const ElementPoints& inner, PairPart part, PairMoments& moments) {
  moments.evaluations += static_cast<std::int64_t>(outer.count) * inner.count;
#if defined(__x86_64__)
  if (has_avx2) return add_with_avx2(outer, inner, part, moments);
#endif
  Sums<2>::add(outer, inner, part, moments);
}

void add_singular_sums(const SingularPoints& points, PairPart part, PairMoments& moments) {
  moments.evaluations += static_cast<std::int64_t>(points.radii) * points.angles;
#if defined(__x86_64__)
  if (has_avx2) return add_with_avx2(points, part, moments);
#endif
  Sums<2>::add(points, part, moments);
}

}  // namespace bempd::bem
