#include "bezcert/io/curve/read.hpp"

#include "bezcert/io/curve/bez_json.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/format_table.hpp"

namespace bezcert {
namespace {

using Format = FileFormat<std::vector<InputCurve>(const std::string& file, std::string_view bytes)>;

// One line a format.
constexpr Format formats[] = {
    {".bez.json (starting with {)", "{", read_bez_json_curves},
};

}  // namespace

std::vector<InputCurve> read_curves(const std::string& file, std::string_view bytes) {
  return format_of(formats, file, bytes).read(file, bytes);
}

std::vector<InputCurve> read_curves_file(const std::string& path) {
  return read_curves(path, read_file(path));
}

}  // namespace bezcert
