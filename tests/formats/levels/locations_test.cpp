#include "formats/levels/locations.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace temblor::formats {
namespace {

TEST(Locations, ReadsPointsAndBoxes) {
  const std::vector<Location> found = read_locations(
      "// places of a level\r\n"
      "800 -1600 8 quad stairs\r\n"
      "\n"
      "100,-50,10,-100,50.5,-10,\"red armor\"\n"
      "  -8  16  24\t$loc_name_ra$loc_name_separatorlow");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].name, "quad stairs");
  EXPECT_EQ(found[0].box.mins, math::Vec3(100, -200, 1));
  EXPECT_EQ(found[0].box.maxs, math::Vec3(100, -200, 1));
  EXPECT_EQ(found[1].name, "red armor");
  EXPECT_EQ(found[1].box.mins, math::Vec3(-100, -50, -10));
  EXPECT_EQ(found[1].box.maxs, math::Vec3(100, 50.5f, 10));
  EXPECT_EQ(found[2].name, "ra-low");
  EXPECT_EQ(found[2].box.mins, math::Vec3(-1, 2, 3));
}

TEST(Locations, SkipsLinesOfNoStyle) {
  for (const char* text : {"", "\n\n", "1 2 3", "1 2 name", "nan 1 2 name", "1e30 0 0 name", "1,2,3,4,5,name",
                           "1 2 3 \"\"", "1,2,3,4,5,6,", "name", "1 2 3 \x01\x02"})
    EXPECT_TRUE(read_locations(text).empty()) << text;
}

TEST(Locations, AreBounded) {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "1 2 3 " + std::string(100, 'a') + "\n";
  const std::vector<Location> found = read_locations(text);
  ASSERT_EQ(found.size(), 4096u);
  EXPECT_EQ(found[0].name, std::string(64, 'a'));
}

TEST(Locations, TheSmallestBoxAroundAPointWins) {
  const std::vector<Location> found = read_locations(
      "0,0,0,100,100,100,\"hall\"\n"
      "10,10,10,20,20,20,\"altar\"\n"
      "1600 400 400 gate\n");
  const auto name = [&](math::Vec3 point) { return find_location(found, point)->name; };
  EXPECT_EQ(name({15, 15, 15}), "altar");
  EXPECT_EQ(name({50, 50, 50}), "hall");
  EXPECT_EQ(name({120, 50, 50}), "hall");
  EXPECT_EQ(name({180, 50, 50}), "gate");
  EXPECT_EQ(find_location({}, math::Vec3(0.0f)), nullptr);
}

TEST(Locations, TheNearestPointWins) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    test::Random random(seed);
    std::vector<Location> locations;
    for (int i = 0; i < 20; ++i) {
      const math::Vec3 place = random.in_cube(500);
      locations.push_back({std::to_string(i), {place, place}});
    }
    const math::Vec3 point = random.in_cube(500);
    const Location* found = find_location(locations, point);
    for (const Location& other : locations)
      EXPECT_LE(glm::distance(found->box.mins, point), glm::distance(other.box.mins, point))
          << "seed " << seed;
  }
}

}  // namespace
}  // namespace temblor::formats
