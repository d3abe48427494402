#include "output/pvd.hpp"

#include <system_error>

#include "output/file.hpp"
#include "output/number.hpp"
#include "output/utf8.hpp"
#include "output/xml.hpp"

namespace bempd::output {

void write_pvd(const std::filesystem::path& path, const std::vector<PvdEntry>& entries) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"";
  text.append(vtk_byte_order()).append("\">\n<Collection>\n");
  for (const PvdEntry& entry : entries) {
    if (!fits_xml(entry.file)) {
      throw std::system_error(
          std::make_error_code(std::errc::invalid_argument),
          "cannot write " + printable(path.native()) + ": XML cannot hold the name " + printable(entry.file));
    }
    text.append("<DataSet timestep=\"").append(to_text(entry.time));
    text.append("\" group=\"\" part=\"").append(to_text(std::int64_t{entry.part}));
    text.append("\" file=\"").append(xml_escaped(entry.file)).append("\"/>\n");
  }
  write_file(path, text.append("</Collection>\n</VTKFile>\n"));
}

}  // namespace bempd::output
