#include "formats/archives/archive.h"

#include <gtest/gtest.h>

namespace temblor::formats {
namespace {

TEST(ContainedName, AcceptsNamesOfGameData) {
  for (const char* name : {"a", "maps/start.bsp", "gfx/env/sky_up.tga", "..a/b..", "a.b.c", "sound/x y.wav"})
    EXPECT_TRUE(is_contained_name(name)) << name;
}

TEST(ContainedName, RejectsNamesThatLeaveFolder) {
  for (const char* name : {"", "/", "/etc/passwd", "..", "../x", "a/..", "a/../b", "a/./b", "./a", "a//b",
                           "a/", "a\\b", "..\\b", "c:", "c:/x", "a\nb", "a\tb"})
    EXPECT_FALSE(is_contained_name(name)) << name;
}

}  // namespace
}  // namespace temblor::formats
