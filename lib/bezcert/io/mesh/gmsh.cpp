#include "bezcert/io/mesh/gmsh.hpp"

#include "bezcert/io/mesh/gmsh_content.hpp"
#include "bezcert/io/printable.hpp"
#include "bezcert/number/interval.hpp"

namespace bezcert {
namespace {

// version, 0 ASCII or 1 binary, bytes of a number; in a binary file the integer 1 follows. Returns the major
// version.
int read_format(GmshSource& source) {
  source.read_tokens("the version, file type and data size");
  source.expect_tokens(3, "$MeshFormat: version, file type, data size");
  const std::string version(source.tokens()[0]);
  const bool two = version == "2" || (version.size() > 2 && version.starts_with("2.") &&
                                      version.find_first_not_of("0123456789", 2) == std::string::npos);
  if (!two && version != "4.1") {
    source.fail("version " + printable(version) +
                " is not read: expected 2.2 or 4.1 (in gmsh: Mesh.MshFileVersion)");
  }
  const std::int64_t type = source.integer(1, "file type");
  if (type != 0 && type != 1) {
    source.fail("the file type is " + std::to_string(type) + ", expected 0 (ASCII) or 1 (binary)");
  }
  if (source.integer(2, "data size") != 8) {
    source.fail("the data size is " + printable(source.tokens()[2]) + ", expected 8");
  }
  if (type == 1) {
    source.binary = true;
    const std::int32_t one = source.read_int32("integer 1 that tells the byte order");
    if (one == 0x01000000) {
      source.swap_bytes = true;
    } else if (one != 1) {
      source.fail("the integer that tells the byte order is " + std::to_string(one) + ", expected 1");
    }
  }
  source.expect_end("MeshFormat");
  return two ? 2 : 4;
}

}  // namespace

MeshBuilder read_gmsh(const std::string& file, std::string_view bytes, const ReadOptions& options) {
  GmshSource source(file, bytes);
  GmshContent content(source, options);
  int version = 0;
  for (std::string_view text = source.next_line(); !text.empty(); text = source.next_line()) {
    if (text.front() != '$' || text.size() < 2) {
      source.fail("expected a section such as $Nodes, found other text");
    }
    const std::string section(text.substr(1));
    if (section == "NOD" || section == "ELM") {
      source.fail("version 1 is not read: expected 2.2 or 4.1 (in gmsh: Mesh.MshFileVersion)");
    }
    const bool nodes = section == "Nodes" || section == "ParametricNodes";
    const bool elements = section == "Elements";
    if (section == "MeshFormat") {
      if (version != 0) source.fail("a second $MeshFormat");
      version = read_format(source);
      continue;
    }
    if (!nodes && !elements) {
      source.skip_section(section);
      continue;
    }
    if (version == 0) source.fail("$" + section + " before $MeshFormat");
    bool& seen = nodes ? content.has_nodes : content.has_elements;
    if (seen) source.fail("a second $" + section + " section");
    seen = true;
    if (nodes && version == 2) read_gmsh2_nodes(source, content, section == "ParametricNodes");
    if (nodes && version == 4) read_gmsh4_nodes(source, content);
    if (elements && version == 2) read_gmsh2_elements(source, content);
    if (elements && version == 4) read_gmsh4_elements(source, content);
    source.expect_end(section);
  }
  if (version == 0) source.fail_at(0, "there is no $MeshFormat section: the file is truncated or no .msh");
  return content.finish();
}

}  // namespace bezcert
