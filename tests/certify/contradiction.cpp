// A contradiction ends in the right place: of a claimed criterion in a finding, of a sound one in exit code 4
// and a reproducer. The second must never happen, so the test brings a false "theorem" of its own.
#include "bezcert/element/forms.hpp"
#include "bezcert/io/file.hpp"
#include "bezcert/io/mesh/read.hpp"
#include "check.hpp"
#include "exit_code.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>

using namespace bezcert;
using namespace bezcert::certify;

namespace {

namespace fs = std::filesystem;

Verdict always_proved(const Forms&);
constexpr Criterion everything_is_fine{"everything-is-fine", "none", "false on purpose", Claim::regular,
                                       Standing::sound,      false,  always_proved};
Verdict always_proved(const Forms&) { return begin_verdict(everything_is_fine, Status::proved); }

// A folder of its own, entered for the time of the test.
class Scratch {
 public:
  Scratch()
      : before_(fs::current_path()),
        folder_(fs::temp_directory_path() / ("bezcert_contradiction_test_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    fs::current_path(folder_);
  }
  ~Scratch() {
    fs::current_path(before_);
    fs::remove_all(folder_);
  }

 private:
  fs::path before_, folder_;
};

const std::string folded =
    std::string(BEZCERT_SOURCE_DIR) + "/corpus/elements/control-net-folded-quadratic.bez.json";

int run(std::vector<const Criterion*> criteria, const std::string& output) {
  CheckArguments options;
  options.meshes = {folded};
  options.criteria = std::move(criteria);
  options.output = output;
  return check(options);
}

}  // namespace

TEST_CASE("a sound criterion that contradicts gives exit code 4 and a reproducer that reads back") {
  const Scratch scratch;
  REQUIRE(run({&everything_is_fine}, "report.txt") == exit_contradiction);
  CHECK(read_file("report.txt").find("CONTRADICTION") != std::string::npos);
  const std::string reproducer = "bezcert-contradiction-control-net-folded-quadratic.bez.json-1.bez.json";
  REQUIRE(fs::exists(reproducer));
  const Mesh kept = read_mesh(reproducer, read_file(reproducer));
  const Mesh original = read_mesh(folded, read_file(folded));
  REQUIRE(kept.elements().size() == 1);
  for (std::size_t i = 0; i < original.node_count(); ++i) {
    CHECK(kept.coordinates(0)[i] == original.coordinates(0)[i]);
    CHECK(kept.coordinates(1)[i] == original.coordinates(1)[i]);
  }
}

TEST_CASE("a claimed criterion that contradicts is a finding and no defect") {
  const Scratch scratch;
  REQUIRE(run({find_criterion("control-net")}, "report.txt") == exit_invalid);
  const std::string report = read_file("report.txt");
  CHECK(report.find("finding: control-net (XC15 Theorem 2.1, for any degree, claimed) says proved regular, "
                    "but the element is folded") != std::string::npos);
  CHECK(report.find("findings: 1") != std::string::npos);
  CHECK(report.find("CONTRADICTION") == std::string::npos);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(".")) ++files;
  CHECK(files == 1);
}
