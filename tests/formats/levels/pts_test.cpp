#include "formats/levels/pts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace temblor::formats {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Pts, ReadsOnePointALine) {
  const auto points = read_pts("1 2 3\n\n -4.50\t5e1 -0.25 \r\n7 8 9 extra");
  ASSERT_TRUE(points.ok()) << points.error().message();
  EXPECT_THAT(*points, ElementsAre(math::Vec3(1, 2, 3), math::Vec3(-4.5f, 50, -0.25f), math::Vec3(7, 8, 9)));
  EXPECT_THAT(read_pts("").value(), IsEmpty());
  EXPECT_THAT(read_pts("\n \r\n").value(), IsEmpty());
}

TEST(Pts, NamesTheDamagedLine) {
  const auto error_text = [](std::string_view text) { return read_pts(text).error().what; };
  EXPECT_THAT(error_text("1 2 3\n\n4 5\n"), HasSubstr("line 3: \"4 5\" is not a point"));
  for (const std::string_view line :
       {"1 2 x", "1 2 3x", "nan 0 0", "1e99 0 0", "1,2,3", "inf 1 2", "\x01 1 2"})
    EXPECT_THAT(error_text(line), HasSubstr("line 1: ")) << line;
}

}  // namespace
}  // namespace temblor::formats
