// Saved places of a demo.
#include "client/demo/demo_index.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "client/demo/demo_builder.h"
#include "client/session/messages.h"

namespace temblor::test {
namespace {

constexpr std::uint16_t kHighest = net::kMaxEntities - 1;
// The longest gap that a demo's clock counts.
constexpr float kGap_s = 0.1f;

// An entity that moves by 8 units in each packet, with the highest number, so that tables of entities are as
// long as they can be.
DemoBuilder long_way(int packets, std::uint16_t number) {
  DemoBuilder demo;
  demo.signon(server_info());
  for (int i = 0; i < packets; ++i)
    demo.packet(1 + kGap_s * static_cast<float>(i), {update_at(1, kPlayerModel, {0, 0, 0}),
                                                     update_at(number, kPlayerModel, {8 * (i % 400), 0, 0})});
  return demo;
}

float farthest_x(client::DemoPlayer& io_player) {
  float x = 0;
  for (const client::InterpolatedEntity& entity :
       io_player.state().interpolate_entities(io_player.server_time_s(), {}))
    x = std::max(x, entity.origin_world.x);
  return x;
}

client::DemoPlayer play(const DemoBuilder& demo) {
  return client::DemoPlayer::open(demo.bytes(), "test.dem").value();
}

TEST(DemoIndex, TheLargestStatesAreNotStoredTooOften) {
  const DemoBuilder demo = long_way(2000, kHighest);
  client::DemoPlayer player = play(demo), straight = play(demo);
  const auto index = client::DemoIndex::make(player);
  ASSERT_TRUE(index.ok());
  EXPECT_LE(index->memory_bytes(), client::DemoIndex::kMaxBytes);
  EXPECT_GT(index->memory_bytes(), sizeof(float) * 3 * kHighest) << "at least a place for each entity";
  // Any time is still found from the place before it.
  for (double time_s = 5; time_s < 190; time_s += 37.3) {
    player.restore(index->find_entry_before(time_s, 1).place);
    ASSERT_TRUE(player.advance_to(time_s).value());
    ASSERT_TRUE(straight.advance_to(time_s).value());
    EXPECT_EQ(farthest_x(player), farthest_x(straight)) << time_s;
  }
}

TEST(DemoIndex, OrdinaryStatesAreStoredOften) {
  client::DemoPlayer player = play(long_way(2000, 5));
  const auto index = client::DemoIndex::make(player);
  ASSERT_TRUE(index.ok());
  EXPECT_LT(index->memory_bytes(), std::size_t{4} << 20);
  for (double time_s = 10; time_s < 190; time_s += 1)
    EXPECT_GT(index->find_entry_before(time_s, 0).time_s, time_s - 4.2) << time_s;
}

}  // namespace
}  // namespace temblor::test
