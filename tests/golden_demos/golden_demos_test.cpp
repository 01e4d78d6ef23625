// The recordings that the game ships with, drawn, against hashes of their pictures in golden.txt: a line for
// each recording and format, a hash for every second. They change with the levels, the art and the rules, and
// then somebody looks at the pictures and writes the hashes anew, with TEMBLOR_REWRITE_GOLDENS set.
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

using Hashes = std::vector<std::uint64_t>;

std::map<std::string, Hashes> golden_hashes() {
  std::map<std::string, Hashes> golden;
  std::ifstream file(kGolden);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string recording, format;
    words >> recording >> format >> std::hex;
    Hashes& hashes = golden[recording + " " + format];
    for (std::uint64_t hash = 0; words >> hash;) hashes.push_back(hash);
  }
  return golden;
}

void write_golden(const std::map<std::string, Hashes>& golden) {
  std::ofstream file(kGolden);
  for (const auto& [name, hashes] : golden) file << fmt::format("{} {:016x}\n", name, fmt::join(hashes, " "));
}

std::vector<std::string> recordings_behind_the_menu() {
  std::istringstream words(read_text(fs::path(TEMBLOR_SHIPPED_FOLDER) / "id1/quake.rc"));
  std::string command;
  words >> command;
  std::vector<std::string> names;
  for (std::string name; words >> name;) names.push_back(name);
  return names;
}

Hashes picture_hashes(const std::string& recording, const std::string& format) {
  const TemporaryFolder folder;
  const ProgramRun ran =
      run_program(folder.path(), {"--basedir", TEMBLOR_SHIPPED_FOLDER, "render", "--demo", recording,
                                  "--color", format, "--fps", "1", "--size", "320x200", "-o", "x-%03d.png"});
  EXPECT_EQ(ran.exit_status, 0) << ran.err;
  EXPECT_EQ(ran.err, "") << "nothing is missing";
  Hashes hashes;
  for (;;) {
    const fs::path picture = folder.path() / fmt::format("x-{:03}.png", hashes.size());
    if (!fs::exists(picture)) return hashes;
    const Png png = read_png(picture);
    hashes.push_back(base::hash_of_bytes(std::as_bytes(std::span(png.rgb))));
  }
}

TEST(Recordings, LookAsTheyDid) {
  const std::vector<std::string> recordings = recordings_behind_the_menu();
  ASSERT_FALSE(recordings.empty());
  const std::map<std::string, Hashes> golden = golden_hashes();
  std::map<std::string, Hashes> now;
  for (const std::string& recording : recordings)
    for (const std::string format : {"indexed", "rgb"})
      now[recording + " " + format] = picture_hashes(recording, format);
  if (std::getenv("TEMBLOR_REWRITE_GOLDENS") != nullptr) {
    write_golden(now);
    GTEST_SKIP() << kGolden << " is written anew: look at the recordings";
  }
  ASSERT_EQ(golden.size(), now.size()) << "each recording has a line for either format in " << kGolden;
  for (const auto& [name, hashes] : now) {
    ASSERT_TRUE(golden.contains(name)) << name << " is not in " << kGolden;
    const Hashes& expected = golden.at(name);
    EXPECT_GE(hashes.size(), 30u) << name;
    EXPECT_EQ(hashes.size(), expected.size()) << name << " is longer or shorter than it was";
    const auto differ = std::mismatch(hashes.begin(), hashes.end(), expected.begin(), expected.end()).first;
    EXPECT_EQ(differ - hashes.begin(), std::ssize(hashes))
        << name << " looks different from second " << differ - hashes.begin() << " on";
  }
}

}  // namespace
}  // namespace temblor::test
