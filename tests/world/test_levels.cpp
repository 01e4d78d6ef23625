#include "world/test_levels.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/small_bsp.h"

namespace temblor::world {

TestLevel test_level(std::string name, formats::Bsp bsp) {
  auto level = make_level(bsp, name);
  CHECK(level.ok(), "{}: {}", name, level.error().message());
  return {std::move(name), std::move(bsp), *level};
}

std::vector<TestLevel> stock_levels(const std::filesystem::path& base_folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(base_folder / "id1" / "maps")) {
    const std::string name = entry.path().stem().string();
    const bool is_sample = name == "b_batt0" || name == "start" || name == "lq_e0m9";
    if (entry.path().extension() == ".bsp" && (!test::kQuick || is_sample)) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<TestLevel> levels;
  for (const std::filesystem::path& path : paths) {
    auto bsp = formats::read_bsp(test::read_file(path));
    CHECK(bsp.ok(), "{}: {}", path.string(), bsp.error().message());
    levels.push_back(test_level(path.stem().string(), std::move(*bsp)));
  }
  CHECK(!levels.empty(), "no levels in {}", base_folder.string());
  return levels;
}

TestLevel small_test_level(const artgen::SmallLevelOptions& options) {
  return test_level("small", test::small_bsp(options));
}

}  // namespace temblor::world
