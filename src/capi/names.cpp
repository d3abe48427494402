#include "scene/names.hpp"

#include "capi/guard.hpp"
#include "output/utf8.hpp"
#include "output/xml.hpp"

using namespace bempd;
using namespace bempd::capi;

namespace {

// Name from the host, checked for characters that files and messages can show; empty text takes a name away.
std::string name_from(const char* name) {
  require(name != nullptr, "name is NULL; give a word, or an empty text to take the name away");
  require(output::fits_xml(name) && output::printable(name) == name, "name is ", output::printable(name),
          "; it must be UTF-8 without control characters");
  return name;
}

}  // namespace

bempd_status bempd_name_region(bempd_model* model, int32_t region, const char* name) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.scene().region(region);
    m.names().set(scene::Names::Kind::region, region, name_from(name));
  });
}

bempd_status bempd_name_edge(bempd_model* model, int32_t region, int32_t edge, const char* name) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.scene().region_with_edge(region, edge);
    m.names().set_edge(region, edge, name_from(name));
  });
}

bempd_status bempd_name_support(bempd_model* model, int32_t support, const char* name) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.scene().support(support);
    m.names().set(scene::Names::Kind::support, support, name_from(name));
  });
}

bempd_status bempd_name_load(bempd_model* model, int32_t load, const char* name) {
  return with_model(model, __func__, [&](model::Model& m) {
    m.scene().load(load);
    m.names().set(scene::Names::Kind::load, load, name_from(name));
  });
}

bempd_status bempd_edge_named(const bempd_model* model, int32_t region, const char* name, int32_t* edge) {
  return with_model(model, __func__, [&](const model::Model& m) {
    m.scene().region_with_edge(region, 1);
    int32_t& found = out(edge, "edge");
    const std::string wanted = name_from(name);
    require(!wanted.empty(), "name is empty; give the name of an edge");
    const std::vector<int> edges = m.names().edges(region, wanted), named = m.names().edges(region);
    std::string numbers, known;
    for (const int one : edges) numbers += text(numbers.empty() ? "" : ", ", one);
    for (const int one : named) {
      const std::string quoted = "\"" + m.names().of_edge(region, one) + "\"";
      if (known.find(quoted) == std::string::npos) known += (known.empty() ? "" : ", ") + quoted;
    }
    require(!edges.empty(), "no edge of region ", region, " has the name \"", wanted, "\"; ",
            known.empty() ? "its edges have no names, bempd_name_edge() gives one" : "its edges are named " + known);
    require(edges.size() == 1, "\"", wanted, "\" is the name of ", edges.size(), " edges of region ", region, ": ",
            numbers, "; give their numbers");
    found = edges.front();
  });
}
