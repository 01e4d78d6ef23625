// Pictures of the laboratory's techniques against the oracle.
#include <gtest/gtest.h>

#include "lab/registry.h"
#include "oracle/judge_pictures.h"
#include "support/effort.h"
#include "support/game_data.h"

namespace temblor::lab {
namespace {

// Every technique, and those variants that have another order or comparison.
constexpr auto kChoices = {"painter",
                           "painter:pvs=0",
                           "z-buffer",
                           "z-buffer:order=1",
                           "beam-tree",
                           "beam-tree:bands=0",
                           "span-sorting",
                           "span-sorting:depth=1",
                           "independent-edges",
                           "abutting-edges",
                           "abutting-edges:mesh=0",
                           "intersecting-edges",
                           "unsplit-edges",
                           "cached-order",
                           "leaf-faces",
                           "portals",
                           "portals:octagon=1",
                           "portals:pvs=1",
                           "equal-z-spans",
                           "one-pass",
                           "one-pass:bilinear=0",
                           "gouraud",
                           "gouraud:triangles=1,perspective=1",
                           "gouraud:spot=1",
                           "gouraud:cut=32",
                           "phong",
                           "phong:smooth=60"};

// Techniques with other light show other colors.
bool has_engines_light(std::string_view text) {
  return !text.starts_with("gouraud") && !text.starts_with("phong") && text != "one-pass:bilinear=0";
}

void judge(const test::DrawableLevel& level, const char* text, int views) {
  const base::Result<Choice> choice = parse_choice(text);
  ASSERT_TRUE(choice.ok()) << choice.error().what;
  const render::FrameStages stages = choice->make_stages();
  const double allowed = choice->technique->max_wrong_share;
  const oracle::Tally tally =
      oracle::judge_pictures(level, {.views = views, .stages = &stages, .may_be_wrong = allowed > 0});
  if (allowed == 0 && has_engines_light(text)) {
    oracle::expect_right(tally);
    return;
  }
  EXPECT_LE(tally.wrong_face, allowed * static_cast<double>(tally.pixels));
  EXPECT_GE(tally.depth_agreement(), allowed == 0 ? 0.995 : 0);
}

std::string make_name(const char* text) {
  std::string name(text);
  for (char& c : name)
    if (c == '-' || c == ':' || c == '=' || c == ',') c = '_';
  return name;
}

class TechniqueOfSmallLevel : public testing::TestWithParam<const char*> {};

TEST_P(TechniqueOfSmallLevel, ShowsWhatRaysSee) {
  judge(test::small_level(), GetParam(), test::effort(40, 4));
}

INSTANTIATE_TEST_SUITE_P(Techniques, TechniqueOfSmallLevel, testing::ValuesIn(kChoices),
                         [](const auto& test) { return make_name(test.param); });

// Loading levels takes most of the time with sanitizers.
std::vector<const char*> stock_levels() {
  if (test::kQuick) return {"lq_e1m2"};
  return {"start", "lq_e0m1", "lq_e1m2"};
}

using StockCase = std::tuple<const char*, const char*>;
class TechniqueOfStockLevel : public testing::TestWithParam<StockCase> {};

TEST_P(TechniqueOfStockLevel, ShowsWhatRaysSee) {
  DATA_FOLDER_OR_SKIP(data);
  judge(test::stock_level(data, std::get<0>(GetParam())), std::get<1>(GetParam()), test::effort(15, 2));
}

INSTANTIATE_TEST_SUITE_P(Levels, TechniqueOfStockLevel,
                         testing::Combine(testing::ValuesIn(stock_levels()), testing::ValuesIn(kChoices)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param)) + "_" +
                                  make_name(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace temblor::lab
