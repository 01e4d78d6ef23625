// Renders the demos that the game ships with and compares hashes of their pictures with golden.txt, which has
// a line for each demo and color format, with one hash per second. The hashes change with the levels, the
// art, and the game rules. Then look at the pictures, and rewrite the hashes by setting
// TEMBLOR_REWRITE_GOLDENS.
//
// Eleven pictures differ between processors of AMD (golden.txt) and Intel (golden_intel.txt, which has the
// lines that differ), because the levels are lit here. Probably samples of light are rounded differently:
// Embree's reciprocals begin with the processor's approximation.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "app/program.h"
#include "base/bytes.h"
#include "base/hash.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;

const fs::path kGolden = TEMBLOR_GOLDEN_RECORDINGS;
const fs::path kGoldenIntel = kGolden.parent_path() / "golden_intel.txt";

using Hashes = std::vector<std::uint64_t>;

std::map<std::string, Hashes> read_hashes(const fs::path& path) {
  std::map<std::string, Hashes> golden;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string demo, format;
    words >> demo >> format >> std::hex;
    Hashes& hashes = golden[demo + " " + format];
    for (std::uint64_t hash = 0; words >> hash;) hashes.push_back(hash);
  }
  return golden;
}

void write_golden(const std::map<std::string, Hashes>& golden) {
  std::ofstream file(kGolden);
  for (const auto& [name, hashes] : golden) file << fmt::format("{} {:016x}\n", name, fmt::join(hashes, " "));
}

// Returns the names after `startdemos` in quake.rc.
std::vector<std::string> list_shipped_demos() {
  const std::string script = read_text(fs::path(TEMBLOR_SHIPPED_FOLDER) / "id1/quake.rc");
  constexpr std::string_view kCommand = "startdemos ";
  std::istringstream words(script.substr(script.find(kCommand) + kCommand.size()));
  std::vector<std::string> names;
  for (std::string name; words >> name;) names.push_back(name);
  return names;
}

Hashes picture_hashes(const std::string& demo, const std::string& format) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_program(folder.path(), {"--basedir", TEMBLOR_SHIPPED_FOLDER, "render", "--demo", demo, "--color",
                                  format, "--fps", "1", "--size", "320x200", "-o", "x-%03d.png"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(ran.err, "") << "no file may be missing";
  Hashes hashes;
  for (;;) {
    const fs::path picture = folder.path() / fmt::format("x-{:03}.png", hashes.size());
    if (!fs::exists(picture)) return hashes;
    const Png png = read_png(picture);
    hashes.push_back(base::hash_bytes(std::as_bytes(std::span(png.rgb))));
  }
}

TEST(GoldenDemos, LookUnchanged) {
  const std::vector<std::string> demos = list_shipped_demos();
  ASSERT_FALSE(demos.empty());
  const std::map<std::string, Hashes> golden = read_hashes(kGolden);
  const std::map<std::string, Hashes> golden_intel = read_hashes(kGoldenIntel);
  std::map<std::string, Hashes> now;
  for (const std::string& demo : demos)
    for (const std::string format : {"indexed", "rgb"})
      now[demo + " " + format] = picture_hashes(demo, format);
  if (std::getenv("TEMBLOR_REWRITE_GOLDENS") != nullptr) {
    write_golden(now);
    GTEST_SKIP() << "rewrote " << kGolden << "; look at the demos";
  }
  ASSERT_EQ(golden.size(), now.size()) << kGolden << " needs one line per demo and color format";
  for (const auto& [name, hashes] : now) {
    ASSERT_TRUE(golden.contains(name)) << name << " is not in " << kGolden;
    if (golden_intel.contains(name) && golden_intel.at(name) == hashes) continue;
    const Hashes& expected = golden.at(name);
    EXPECT_GE(hashes.size(), 30u) << name;
    EXPECT_EQ(hashes.size(), expected.size()) << name << " has a different length";
    const auto differ = std::mismatch(hashes.begin(), hashes.end(), expected.begin(), expected.end()).first;
    EXPECT_EQ(differ - hashes.begin(), std::ssize(hashes))
        << name << " looks different from second " << differ - hashes.begin() << " on";
  }
}

}  // namespace
}  // namespace temblor::test
