// Finished levels, lit again and compared with the light that their makers computed.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "compiler/light/lighting.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "world/level.h"

namespace temblor::test {
namespace {

// The light of a luxel with all styles on.
double read_luxel(const formats::Bsp& bsp, std::size_t face, std::size_t luxels, std::size_t luxel) {
  const formats::BspFace& shape = bsp.faces[face];
  double sum = 0;
  for (std::size_t style = 0; style < 4 && shape.light_offset >= 0 && shape.styles[style] != 255; ++style)
    sum += bsp.lighting.at(static_cast<std::size_t>(shape.light_offset) + style * luxels + luxel);
  return std::min(sum, 255.0);
}

struct MeanLight {
  double makers = 0, ours = 0, difference = 0;
};
// Over the faces that are lit in either level.
MeanLight compare(const formats::Bsp& makers, const formats::Bsp& ours) {
  const auto level = world::make_level(ours, "ours").value();
  MeanLight mean;
  double count = 0;
  for (std::size_t face = 0; face < makers.faces.size(); ++face) {
    if (makers.faces[face].light_offset < 0 && ours.faces[face].light_offset < 0) continue;
    const auto luxels = static_cast<std::size_t>(level->faces[face].light_width()) *
                        static_cast<std::size_t>(level->faces[face].light_height());
    for (std::size_t luxel = 0; luxel < luxels; ++luxel, ++count) {
      const double a = read_luxel(makers, face, luxels, luxel), b = read_luxel(ours, face, luxels, luxel);
      mean.makers += a;
      mean.ours += b;
      mean.difference += std::abs(a - b);
    }
  }
  return {mean.makers / count, mean.ours / count, mean.difference / count};
}

struct StockLevel {
  const char* name;
  compiler::LightOptions options;  // the makers' options, as far as they are known
};

TEST(LightStock, MeanLightMatchesFinishedLevels) {
  DATA_FOLDER_OR_SKIP(base_folder);
  std::vector<StockLevel> levels{{"lqdm1", {.bounces = 3, .dirt = true}}};
  if (!kQuick) levels.insert(levels.end(), {{"lq_e1m2", {.bounces = 8, .dirt = true}}, {"lq_e0m1", {}}});
  for (const StockLevel& stock : levels) {
    const std::string name = stock.name;
    const formats::Bsp makers =
        formats::read_bsp(read_file(base_folder / "id1/maps" / (name + ".bsp"))).value();
    const LitResult ours = light(makers, stock.options, 2);
    const MeanLight mean = compare(makers, ours.bsp);
    ::testing::Test::RecordProperty(
        name, fmt::format("{:.1f} for {:.1f}, {:.1f} apart", mean.ours, mean.makers, mean.difference));
    EXPECT_NEAR(mean.ours, mean.makers, 5) << name;
    EXPECT_LT(mean.difference, 28) << name;
  }
}

}  // namespace
}  // namespace temblor::test
