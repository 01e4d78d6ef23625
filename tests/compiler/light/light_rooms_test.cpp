// Rooms with one light feature each: the number, mean and maximum of their light samples beside those of
// ericw-tools 2.0, which makers of levels know. It cuts faces in other places: a room lit all over has 7%
// more samples, and one lit in part has more or fewer dark ones. In the first case the mean is comparable, in
// the second the sum.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "compiler/light/lit_map.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using math::Vec3d;

struct Measured {
  double samples, mean, most;
};

// The light of a room, and ericw-tools' result.
struct LitRoom {
  const char* name;
  std::string world_keys;
  std::string light_keys;  // of the light below; with its own "light" and "origin" these count
  std::string brushes;     // in addition to walls and a pillar
  Measured expected;
  bool has_sky = false;  // as its ceiling, and no light
};

std::string key(const char* name, const char* value) {
  return fmt::format("\"{}\" \"{}\"\n", name, value);
}

const std::string kLight = key("origin", "150 256 180") + key("light", "250");
const std::string kLampAt = key("origin", "20 20 20") + key("_surface", "lamp");

std::string lamp_text(double low, double high) {
  return box_text({low, low, 200}, {high, high, 216}, "lamp");
}

std::string lit_room_text(const LitRoom& room) {
  std::string brushes = walls_text({0, 0, 0}, {512, 512, room.has_sky ? 272 : 256}, "wall");
  if (room.has_sky) brushes += box_text({-16, -16, 256}, {528, 528, 272}, "sky1");
  brushes += box_text({300, 300, 0}, {364, 364, 128}, "wall") + room.brushes;
  return entity_text("worldspawn", room.world_keys, brushes) + point_text("info_player_start", {64, 64, 32}) +
         (room.has_sky ? std::string() : entity_text("light", room.light_keys));
}

std::vector<LitRoom> list_rooms() {
  const std::string lit_lamp = kLampAt + key("light", "120");
  return {
      {"plain", "", kLight, "", {2724, 14.3, 87}},
      {"delay1", "", kLight + key("delay", "1"), "", {5556, 47.6, 212}},
      {"delay2", "", kLight + key("delay", "2"), "", {5556, 27.0, 255}},
      {"delay3", "", kLight + key("delay", "3"), "", {5556, 96.2, 124}},
      {"delay4", "", kLight + key("delay", "4"), "", {5668, 115.6, 125}},
      {"delay5", "", kLight + key("delay", "5"), "", {5556, 10.1, 49}},
      {"falloff200", "", kLight + key("_falloff", "200"), "", {2156, 7.9, 77}},
      {"anglescale1", "", kLight + key("_anglescale", "1"), "", {2724, 11.4, 87}},
      {"world_anglescale0", key("_anglescale", "0"), kLight, "", {2724, 17.2, 87}},
      {"gamma", key("_gamma", "1.5"), kLight, "", {2724, 29.8, 124}},
      {"range", key("_range", "1"), kLight, "", {2724, 28.9, 174}},
      {"maxlight", key("_maxlight", "60"), kLight, "", {2724, 13.9, 60}},
      {"minlight30", key("_minlight", "30"), kLight, "", {5684, 18.0, 87}},
      {"dirt", key("_dirt", "1"), kLight, "", {2724, 13.6, 87}},
      {"bounce1", key("_bounce", "1"), kLight, "", {5628, 12.3, 95}},
      {"bounce4", key("_bounce", "4"), kLight, "", {5684, 21.5, 111}},
      {"bounce_s", key("_bounce", "1") + key("_bouncescale", "2"), kLight, "", {5628, 18.1, 104}},
      {"surf", "", lit_lamp, lamp_text(100, 164), {1216, 25.2, 216}},
      {"surf_al", "", lit_lamp, lamp_text(64, 128), {1184, 12.1, 82}},
      {"surf_d2",
       "",
       kLampAt + key("light", "400") + key("delay", "2"),
       lamp_text(64, 128),
       {5580, 97.8, 255}},
      {"surf_spot", "", lit_lamp + key("_surface_spotlight", "1"), lamp_text(100, 164), {684, 1.2, 41}},
      {"sunlight2", key("_sunlight2", "120"), "", "", {4440, 14.2, 34}, true},
  };
}

class LightRooms : public ::testing::TestWithParam<LitRoom> {};

TEST_P(LightRooms, LightIsWithinFivePercent) {
  const LitRoom& room = GetParam();
  const auto level = lit_map(lit_room_text(room));
  const double sum = std::accumulate(level->light.begin(), level->light.end(), 0.0);
  const double most = *std::max_element(level->light.begin(), level->light.end());
  const double expected = room.expected.samples * room.expected.mean;
  const double mean = sum / static_cast<double>(level->light.size());
  EXPECT_LE(std::min(std::abs(sum / expected - 1), std::abs(mean / room.expected.mean - 1)), 0.05)
      << sum << " for " << expected << ", mean " << mean << " for " << room.expected.mean;
  EXPECT_NEAR(most, room.expected.most, std::max(1.0, 0.05 * room.expected.most));
}

INSTANTIATE_TEST_SUITE_P(OfEricwTools, LightRooms, ::testing::ValuesIn(list_rooms()),
                         [](const auto& room) { return std::string(room.param.name); });

// Liquids are lit unless a key says no, and from both sides.
TEST(LightRooms, LiquidsAddSamplesOfTheSameMean) {
  const std::string water = box_text({0, 0, 0}, {512, 200, 40}, "*water");
  const auto measure = [&](const std::string& world_keys) {
    const auto level = lit_map(lit_room_text({"", world_keys, kLight, water, {}}));
    return Measured{static_cast<double>(level->light.size()),
                    std::accumulate(level->light.begin(), level->light.end(), 0.0) /
                        static_cast<double>(level->light.size()),
                    0};
  };
  const Measured lit = measure("");
  EXPECT_EQ(measure(key("_litwater", "1")).samples, lit.samples);
  for (const char* name : {"_litwater", "_splitturb"})
    EXPECT_LT(measure(key(name, "0")).samples, lit.samples - 900) << "both sides of 512 x 200";
  EXPECT_NEAR(lit.mean, 13.5, 0.05 * 13.5);
}

}  // namespace
}  // namespace temblor::test
