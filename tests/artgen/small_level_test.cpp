#include "artgen/small_level.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "formats/bsp.h"

namespace temblor::artgen {
namespace {

struct NamedOptions {
  std::string name;
  SmallLevelOptions options;
};

std::vector<NamedOptions> every_option() {
  return {{"Plain", {}},
          {"NoPvs", {.pvs = false}},
          {"NoLight", {.light = false}},
          {"FourStyles", {.four_styles = true}},
          {"WideFaces", {.wide_faces = true}},
          {"EdgeUsedThreeTimes", {.edge_used_three_times = true}},
          {"MissingTexture", {.missing_texture = true}},
          {"ColouredLight", {.coloured_light = true}},
          {"Tiny", {.tiny = true}},
          {"TinyWithEverything",
           {.four_styles = true,
            .wide_faces = true,
            .edge_used_three_times = true,
            .missing_texture = true,
            .coloured_light = true,
            .tiny = true}}};
}

class EverySmallLevel : public testing::TestWithParam<NamedOptions> {};

TEST_P(EverySmallLevel, IsReadAndWrittenInEveryVersion) {
  const formats::Bsp bsp = make_small_level(GetParam().options);
  for (const auto version :
       {formats::BspVersion::k29, formats::BspVersion::k2Psb, formats::BspVersion::kBsp2}) {
    const auto bytes = formats::write_bsp(bsp, version);
    ASSERT_TRUE(bytes.ok()) << bytes.error().message();
    const auto read = formats::read_bsp(*bytes);
    ASSERT_TRUE(read.ok()) << read.error().message();
    const auto again = formats::write_bsp(*read, version);
    ASSERT_TRUE(again.ok()) << again.error().message();
    EXPECT_EQ(*again, *bytes);
  }
}

INSTANTIATE_TEST_SUITE_P(Options, EverySmallLevel, testing::ValuesIn(every_option()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace temblor::artgen
