#include "client/effects/beams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "support/random.h"

namespace temblor::client {
namespace {

// The direction in which a model points; positive pitch is upward.
math::Vec3 forward(const math::Vec3& angles_deg) {
  const float to_radians = std::numbers::pi_v<float> / 180;
  const float pitch = angles_deg.x * to_radians, yaw = angles_deg.y * to_radians;
  return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}

TEST(Beams, HaveAPieceEvery30Units) {
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const math::Vec3 start = random.in_cube(1000), end = random.in_cube(1000);
    Beams beams;
    beams.add({3, BeamModel::kBolt2, start, end, 0});
    beams.advance(0, std::nullopt);
    const float length = glm::distance(start, end);
    const math::Vec3 direction = (end - start) / length;
    ASSERT_EQ(beams.pieces().size(), static_cast<std::size_t>(std::ceil(length / 30)));
    for (std::size_t piece = 0; piece < beams.pieces().size(); ++piece) {
      const BeamPiece& seen = beams.pieces()[piece];
      EXPECT_EQ(seen.model, BeamModel::kBolt2);
      EXPECT_LT(glm::distance(seen.origin_world, start + direction * (30 * static_cast<float>(piece))),
                0.01f);
      EXPECT_LT(glm::distance(forward(seen.angles_deg), direction), 1e-4f);
    }
  }
}

TEST(Beams, PointStraightUpAndDown) {
  Beams beams;
  beams.add({1, BeamModel::kBolt, {0, 0, 0}, {0, 0, 60}, 0});
  beams.add({2, BeamModel::kBolt, {0, 0, 0}, {0, 0, -60}, 0});
  beams.advance(0, std::nullopt);
  ASSERT_EQ(beams.pieces().size(), 4u);
  EXPECT_EQ(beams.pieces()[0].angles_deg.x, 90);
  EXPECT_EQ(beams.pieces()[2].angles_deg.x, 270);
  EXPECT_EQ(beams.pieces()[0].angles_deg.y, 0);
}

TEST(Beams, LiveAFifthOfASecondAndAreOnePerEntity) {
  Beams beams;
  beams.add({1, BeamModel::kBolt, {0, 0, 0}, {25, 0, 0}, 0});
  beams.add({2, BeamModel::kBolt, {0, 0, 0}, {55, 0, 0}, 0});
  beams.add({1, BeamModel::kBolt, {0, 0, 0}, {85, 0, 0}, 0.1});
  beams.advance(0.2, std::nullopt);
  EXPECT_EQ(beams.pieces().size(), 3u + 2);
  beams.advance(0.25, std::nullopt);
  EXPECT_EQ(beams.pieces().size(), 3u);
  beams.advance(0.31, std::nullopt);
  EXPECT_TRUE(beams.pieces().empty());
}

TEST(Beams, TheViewersBeamStartsAtItsEntity) {
  Beams beams;
  beams.add({1, BeamModel::kBolt, {0, 0, 0}, {25, 0, 0}, 0});
  beams.add({2, BeamModel::kBolt, {0, 0, 0}, {25, 0, 0}, 0});
  beams.advance(0, Beams::Anchor{2, {10, 10, 10}});
  EXPECT_EQ(beams.pieces()[0].origin_world, math::Vec3(0, 0, 0));
  EXPECT_EQ(beams.pieces()[1].origin_world, math::Vec3(10, 10, 10));
}

TEST(Beams, PiecesKeepTheirRollForATwentiethOfASecond) {
  const auto rolls_at = [](double time_s) {
    Beams beams;
    beams.add({1, BeamModel::kBolt, {0, 0, 0}, {900, 0, 0}, 1.0});
    beams.advance(time_s, std::nullopt);
    std::vector<float> rolls;
    for (const BeamPiece& piece : beams.pieces()) rolls.push_back(piece.angles_deg.z);
    return rolls;
  };
  EXPECT_EQ(rolls_at(1.001), rolls_at(1.049));
  EXPECT_NE(rolls_at(1.049), rolls_at(1.051));
  const std::vector<float> rolls = rolls_at(1.01);
  int same = 0;
  for (std::size_t i = 1; i < rolls.size(); ++i) same += rolls[i] == rolls[i - 1];
  EXPECT_LE(same, 2);
}

TEST(Beams, NumberAndLengthAreLimited) {
  Beams beams;
  for (std::uint32_t i = 0; i < Beams::kMaxBeams + 10; ++i)
    beams.add({i + 1, BeamModel::kBolt, {0, 0, 0}, {10, 0, static_cast<float>(i)}, 0.001 * i});
  beams.advance(0.1, std::nullopt);
  EXPECT_GE(beams.pieces().size(), Beams::kMaxBeams);
  for (const BeamPiece& piece : beams.pieces()) EXPECT_GT(piece.angles_deg.x, 40);  // the first ten are gone
  beams.clear();
  // The largest coordinates of messages.
  beams.add({1, BeamModel::kBolt, {0, 0, 0}, {0x1p27f, 0, 0}, 0});
  beams.advance(0, std::nullopt);
  EXPECT_EQ(beams.pieces().size(), static_cast<std::size_t>(Beams::kMaxPieces));
}

}  // namespace
}  // namespace temblor::client
