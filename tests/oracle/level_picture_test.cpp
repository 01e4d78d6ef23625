// The renderer's pictures against the oracle: the visible face, its depth, and its color.
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "oracle/judge_pictures.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::oracle {
namespace {

std::string picture_name(const char* level, render::PixelFormat format) {
  return fmt::format("{}_{}", level, format == render::PixelFormat::kIndexed ? "indexed" : "rgb");
}

using StockCase = std::tuple<const char*, render::PixelFormat>;
class StockLevelPicture : public testing::TestWithParam<StockCase> {};

TEST_P(StockLevelPicture, IsWhatRaysSee) {
  DATA_FOLDER_OR_SKIP(data);
  const auto& [map_name, format] = GetParam();
  const Tally tally =
      judge_pictures(test::stock_level(data, map_name), {.format = format, .views = test::effort(200, 10)});
  expect_right(tally);
  if (!test::kQuick) {
    EXPECT_GT(tally.on_brush_models, tally.pixels / 1000) << "too few to say anything of doors";
  }
}

TEST_P(StockLevelPicture, IsWhatParallelRaysSee) {
  DATA_FOLDER_OR_SKIP(data);
  const auto& [map_name, format] = GetParam();
  expect_right(judge_pictures(
      test::stock_level(data, map_name),
      {.format = format, .projection = render::Projection::kOrthographic, .views = test::effort(40, 2)}));
}

constexpr auto kFormats = {render::PixelFormat::kIndexed, render::PixelFormat::kRgb};

INSTANTIATE_TEST_SUITE_P(Levels, StockLevelPicture,
                         testing::Combine(testing::Values("start", "lq_e0m1", "lq_e1m2"),
                                          testing::ValuesIn(kFormats)),
                         [](const auto& test) {
                           return picture_name(std::get<0>(test.param), std::get<1>(test.param));
                         });

using SmallCase = std::tuple<test::SmallLevelVariant, render::PixelFormat>;
class SmallLevelPicture : public testing::TestWithParam<SmallCase> {};

TEST_P(SmallLevelPicture, IsWhatRaysSee) {
  const auto& [variant, format] = GetParam();
  expect_right(judge_pictures(test::small_level(variant.options, variant.name),
                              {.format = format, .views = test::effort(100, 4)}));
}

INSTANTIATE_TEST_SUITE_P(Variants, SmallLevelPicture,
                         testing::Combine(testing::ValuesIn(test::small_level_variants()),
                                          testing::ValuesIn(kFormats)),
                         [](const auto& test) {
                           return picture_name(std::get<0>(test.param).name, std::get<1>(test.param));
                         });

}  // namespace
}  // namespace temblor::oracle
