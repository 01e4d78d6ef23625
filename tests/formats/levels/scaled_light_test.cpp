#include "formats/levels/scaled_light.h"

#include <gtest/gtest.h>

#include <string>

#include "formats/levels/cube_room.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::formats {
namespace {

using test::effort;
using test::Random;

std::vector<ScaledLightMap> make_random_scaled_maps(Random& random, std::size_t faces) {
  std::vector<ScaledLightMap> maps(faces);
  for (ScaledLightMap& map : maps) {
    map.shift = static_cast<std::uint8_t>(random.below(kMaxLightShift + 1));
    map.offset = random.chance(0.2) ? -1 : static_cast<std::int32_t>(random.below(1u << 31));
    for (std::uint8_t& style : map.styles) style = static_cast<std::uint8_t>(random.bits());
  }
  return maps;
}

// Through a whole file.
TEST(ScaledLight, ReadsBackWhatItWrites) {
  for (int seed = 0; seed < effort(200, 20); ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Bsp bsp = test::make_cube_room();
    const std::vector<ScaledLightMap> maps = make_random_scaled_maps(random, bsp.faces.size());
    set_scaled_light(maps, bsp);
    const auto back = read_bsp(write_bsp(bsp, BspVersion::k29).value());
    ASSERT_TRUE(back.ok()) << back.error().message();
    const auto read = read_scaled_light(*back);
    ASSERT_TRUE(read.ok()) << read.error().message();
    EXPECT_EQ(*read, maps) << seed;
    set_scaled_light({}, bsp);
    EXPECT_EQ(bsp, test::make_cube_room()) << seed;
    EXPECT_TRUE(read_scaled_light(bsp).value().empty());
  }
}

TEST(ScaledLight, FacesFillInForMissingLumps) {
  Bsp bsp = test::make_cube_room();
  bsp.faces[2].light_offset = 77;
  bsp.faces[2].styles = {3, 4, 255, 255};
  bsp.bspx.push_back({"LMSHIFT", base::ByteVector(bsp.faces.size(), std::byte{2})});
  const auto maps = read_scaled_light(bsp).value();
  ASSERT_EQ(maps.size(), bsp.faces.size());
  EXPECT_EQ(maps[2], (ScaledLightMap{2, 77, {3, 4, 255, 255}}));
}

TEST(ScaledLight, WideStylesReplaceTheOthers) {
  Bsp bsp = test::make_cube_room();
  bsp.bspx.push_back({"LMSTYLE", base::ByteVector(bsp.faces.size() * 4, std::byte{9})});
  base::ByteWriter writer;
  for (std::size_t face = 0; face < bsp.faces.size(); ++face)
    for (const std::uint16_t style : {std::uint16_t{0}, std::uint16_t{33}, std::uint16_t{65535},
                                      std::uint16_t{65535}, std::uint16_t{65535}})
      writer.u16(style);
  EXPECT_EQ(read_face_styles(bsp).value()[0], (FaceStyles{9, 9, 9, 9}));
  bsp.bspx.push_back({"LMSTYLE16", std::move(writer).take()});
  const auto wide = read_face_styles(bsp).value();
  EXPECT_EQ(wide, std::vector<FaceStyles>(bsp.faces.size(), {0, 33, 255, 255}));
}

TEST(ScaledLight, ErrorsNameTheLumpAndTheFace) {
  const Bsp room = test::make_cube_room();
  const std::size_t faces = room.faces.size();
  const auto what = [&](const char* name, base::ByteVector data) {
    Bsp bsp = room;
    if (std::string(name) != "LMSHIFT")
      bsp.bspx.push_back({"LMSHIFT", base::ByteVector(faces, std::byte{4})});
    bsp.bspx.push_back({name, std::move(data)});
    const auto read = read_scaled_light(bsp);
    return read.ok() ? std::string("no error") : read.error().what;
  };
  EXPECT_EQ(what("LMSHIFT", base::ByteVector(5)), "lump LMSHIFT: 5 bytes, but 6 faces need 6");
  EXPECT_EQ(what("LMOFFSET", base::ByteVector(6)), "lump LMOFFSET: 6 bytes, but 6 faces need 24");
  EXPECT_EQ(what("LMSTYLE", base::ByteVector(25)), "lump LMSTYLE: 25 bytes, but 6 faces need 24");
  EXPECT_EQ(what("LMSTYLE16", base::ByteVector(18)),
            "lump LMSTYLE16: 18 bytes are not a whole number of styles for each of 6 faces");
  EXPECT_EQ(what("LMSTYLE16", {}),
            "lump LMSTYLE16: 0 bytes are not a whole number of styles for each of 6 faces");
  base::ByteVector shifts(6, std::byte{4});
  shifts[3] = std::byte{16};
  EXPECT_EQ(what("LMSHIFT", shifts), "lump LMSHIFT: face 3 has shift 16, but the highest is 15");
  base::ByteVector offsets(24);
  offsets[11] = std::byte{0x80};
  EXPECT_EQ(what("LMOFFSET", offsets), "lump LMOFFSET: face 2 has offset -2147483648");
  base::ByteVector styles(48);
  styles[9] = std::byte{1};
  EXPECT_EQ(what("LMSTYLE16", styles), "lump LMSTYLE16: face 1 has light style 256");
}

}  // namespace
}  // namespace temblor::formats
