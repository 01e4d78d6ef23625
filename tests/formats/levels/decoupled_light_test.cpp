#include "formats/levels/decoupled_light.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "formats/levels/cube_room.h"
#include "support/effort.h"
#include "support/mutations.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using test::effort;
using test::Random;

std::vector<DecoupledLightMap> make_random_decoupled_maps(Random& random, std::size_t faces) {
  std::vector<DecoupledLightMap> maps(faces);
  for (DecoupledLightMap& map : maps) {
    map.width = static_cast<std::uint16_t>(random.bits());
    map.height = static_cast<std::uint16_t>(random.bits());
    map.offset = random.chance(0.2) ? -1 : static_cast<std::int32_t>(random.below(1u << 31));
    map.x_axis = random.in_cube(2);
    map.y_axis = random.in_cube(2);
    map.x_offset = random.in_cube(4000).x;
    map.y_offset = random.in_cube(4000).y;
  }
  return maps;
}

// Through a whole file.
TEST(DecoupledLight, ReadsBackWhatItWrites) {
  for (int seed = 0; seed < effort(200, 20); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Bsp bsp = test::make_cube_room();
    const std::vector<DecoupledLightMap> maps = make_random_decoupled_maps(random, bsp.faces.size());
    set_decoupled_light(maps, bsp);
    const auto back = read_bsp(write_bsp(bsp, BspVersion::kBsp2).value());
    ASSERT_TRUE(back.ok()) << back.error().message();
    const auto read = read_decoupled_light(*back);
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(*read, maps) << seed;
    set_decoupled_light({}, bsp);
    EXPECT_EQ(bsp, test::make_cube_room()) << seed;
  }
}

// Bytes written by hand, field by field.
TEST(DecoupledLight, HasFortyBytesForEachFace) {
  Bsp bsp = test::make_cube_room();
  base::ByteWriter writer;
  for (std::size_t face = 0; face < bsp.faces.size(); ++face) {
    writer.u16(7), writer.u16(300), writer.i32(1234);
    for (const float number : {0.25f, 0.5f, -1.0f, 3.0f, 1.0f, 2.0f, 4.0f, -8.0f}) writer.f32(number);
  }
  ASSERT_EQ(writer.size(), 240u);
  bsp.bspx.push_back({"DECOUPLED_LM", std::move(writer).take()});
  const auto maps = read_decoupled_light(bsp).value();
  ASSERT_EQ(maps.size(), 6u);
  for (const DecoupledLightMap& map : maps)
    EXPECT_EQ(map, (DecoupledLightMap{7, 300, 1234, {0.25f, 0.5f, -1}, 3, {1, 2, 4}, -8}));
}

TEST(DecoupledLight, ErrorsNameTheLumpAndTheFace) {
  Random random(1);
  const auto what = [&](auto change) {
    Bsp bsp = test::make_cube_room();
    std::vector<DecoupledLightMap> maps(bsp.faces.size());
    for (DecoupledLightMap& map : maps) map.offset = 0;
    change(maps[4]);
    set_decoupled_light(maps, bsp);
    const auto read = read_decoupled_light(bsp);
    return read.ok() ? std::string("no error") : read.error().what;
  };
  EXPECT_EQ(what([](DecoupledLightMap&) {}), "no error");
  EXPECT_EQ(what([](DecoupledLightMap& map) { map.offset = -2; }), "lump DECOUPLED_LM: face 4 has offset -2");
  const std::string bad_numbers =
      "lump DECOUPLED_LM: face 4 has axes or offsets that are not finite or too large";
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e20f}) {
    EXPECT_EQ(what([&](DecoupledLightMap& map) { map.y_axis.z = bad; }), bad_numbers);
    EXPECT_EQ(what([&](DecoupledLightMap& map) { map.x_offset = bad; }), bad_numbers);
    // The numbers of a face without light do not matter.
    EXPECT_EQ(what([&](DecoupledLightMap& map) { map.x_offset = bad, map.offset = -1; }), "no error");
  }
  Bsp bsp = test::make_cube_room();
  bsp.bspx.push_back({"DECOUPLED_LM", test::random_bytes(random, 239)});
  EXPECT_EQ(read_decoupled_light(bsp).error().what, "lump DECOUPLED_LM: 239 bytes, but 6 faces need 240");
}

}  // namespace
}  // namespace temblor::formats
