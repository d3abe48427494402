#include "regions/scheme.hpp"

#include "regions/paper/paper_scheme.hpp"
#include "regions/symmetric_scheme.hpp"

namespace bempd::regions {

std::unique_ptr<Scheme> make_scheme(const scene::Options& options) {
  if (options.text_value("scheme") == "paper") return make_paper_scheme(options);
  return make_symmetric_scheme();
}

}  // namespace bempd::regions
