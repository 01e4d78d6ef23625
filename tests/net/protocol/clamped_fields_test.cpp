// Coordinates and angles that QuakeC writes itself: encoded as in whole messages, and always finite.
#include "net/protocol/clamped_fields.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "net/protocol/dialects.h"
#include "net/protocol/message_writer.h"
#include "support/random.h"

namespace temblor::net {
namespace {

using test::k15;
using test::written;

base::ByteVector coord_bytes(float value, const Dialect& dialect) {
  base::ByteWriter writer;
  write_coord(value, dialect, writer);
  return std::move(writer).take();
}
base::ByteVector angle_bytes(float value, const Dialect& dialect) {
  base::ByteWriter writer;
  write_angle_deg(value, dialect, writer);
  return std::move(writer).take();
}

constexpr Dialect kDialects[] = {k15,
                                 {Protocol::kFitzQuake, 0},
                                 {Protocol::kRmq, kShortAngle | k24BitCoord},
                                 {Protocol::kRmq, kShortAngle | kInt32Coord},
                                 {Protocol::kRmq, kFloatCoord | kFloatAngle}};

TEST(ClampedFields, MatchWholeMessages) {
  test::Random random(7);
  for (const Dialect& dialect : kDialects)
    for (int i = 0; i < 200; ++i) {
      const auto value = static_cast<float>(random.uniform(-4000, 4000));
      // A gunshot has two bytes before its coordinates; a set angle has one byte before its angles.
      base::ByteVector three = coord_bytes(value, dialect);
      const base::ByteVector shot =
          written(TempEntity{.kind = TempEntityKind::kGunshot, .origin = math::Vec3(value)}, dialect);
      ASSERT_EQ(base::ByteVector(shot.begin() + 2, shot.begin() + 2 + std::ptrdiff_t(three.size())), three);
      three = angle_bytes(value, dialect);
      const base::ByteVector turn = written(SetAngle{math::Vec3(value)}, dialect);
      ASSERT_EQ(base::ByteVector(turn.begin() + 1, turn.begin() + 1 + std::ptrdiff_t(three.size())), three);
    }
}

TEST(ClampedFields, ClampToRange) {
  const auto eighths = [](float value) {
    return std::bit_cast<std::int16_t>([&] {
      const base::ByteVector bytes = coord_bytes(value, k15);
      return std::array<std::byte, 2>{bytes.at(0), bytes.at(1)};
    }());
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(eighths(5000), 32767);
  EXPECT_EQ(eighths(-5000), -32768);
  EXPECT_EQ(eighths(kInfinity), 32767);
  EXPECT_EQ(eighths(-1e30f), -32768);
  EXPECT_EQ(eighths(NAN), 0);
  for (const Dialect& dialect : kDialects)
    for (const float value : {NAN, kInfinity, -kInfinity, 3e38f, -3e38f, 1e-40f}) {
      EXPECT_EQ(coord_bytes(value, dialect).size(), coord_bytes(0, dialect).size());
      EXPECT_EQ(angle_bytes(value, dialect).size(), angle_bytes(0, dialect).size());
    }
  EXPECT_EQ(angle_bytes(NAN, k15), angle_bytes(0, k15));
}

}  // namespace
}  // namespace temblor::net
