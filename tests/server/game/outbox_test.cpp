// The messages of a tick, and the buffers that they go into.
#include "server/game/outbox.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "net/protocol/dialects.h"

namespace temblor::server {
namespace {

using test::written;

constexpr net::Dialect k15{};
constexpr net::Dialect k666{net::Protocol::kFitzQuake, 0};

TEST(Outbox, OnlyPlayersHaveABufferOfTheirOwn) {
  Outbox outbox(k15, 2);
  EXPECT_EQ(outbox.reliable_to(vm::kWorld), nullptr);
  EXPECT_NE(outbox.reliable_to(vm::EntityIndex{1}), nullptr);
  EXPECT_NE(outbox.reliable_to(vm::EntityIndex{2}), nullptr);
  EXPECT_NE(outbox.reliable_to(vm::EntityIndex{1}), outbox.reliable_to(vm::EntityIndex{2}));
  EXPECT_EQ(outbox.reliable_to(vm::EntityIndex{3}), nullptr);
  EXPECT_EQ(outbox.reliable_to(vm::EntityIndex{0xffffffff}), nullptr);
}

TEST(Outbox, MessagesAreInItsDialect) {
  const net::Sound sound{.entity = 5, .sound = 300};
  Outbox wide(k666, 1);
  wide.write(sound, wide.reliable());
  EXPECT_EQ(wide.reliable().view(), written(sound, k666));
  EXPECT_EQ(wide.dropped(), 0u);
}

TEST(Outbox, MessagesThatTheDialectCannotExpressAreDroppedAndCounted) {
  Outbox outbox(k15, 1);
  outbox.write(net::Print{"before"}, outbox.reliable());
  const base::ByteVector before = outbox.reliable().view();
  outbox.write(net::Sound{.sound = 300}, outbox.reliable());                        // over a byte
  outbox.write(net::Fog{.density = 1}, outbox.reliable());                          // no such message
  outbox.write_at_place(net::Particles{.origin = math::Vec3(1e9f)}, std::nullopt);  // outside of the level
  outbox.write_at_place(net::Particles{.origin = math::Vec3(std::numeric_limits<float>::quiet_NaN())},
                        std::nullopt);
  EXPECT_EQ(outbox.reliable().view(), before);
  EXPECT_TRUE(outbox.placed().empty());
  EXPECT_TRUE(outbox.placed_bytes().empty());
  EXPECT_EQ(outbox.dropped(), 4u);
}

TEST(Outbox, PlacedMessagesKnowTheirPlaceAndBytes) {
  Outbox outbox(k15, 1);
  const net::Particles here{.origin = {1, 2, 3}, .count = 5}, there{.origin = {4, 5, 6}, .count = 6};
  outbox.write_at_place(here, here.origin);
  outbox.write_at_place(there, std::nullopt);
  ASSERT_EQ(outbox.placed().size(), 2u);
  const auto pack_bytes = [&](const Outbox::Placed& placed) {
    const base::Bytes bytes = outbox.placed_bytes().subspan(placed.begin, placed.end - placed.begin);
    return base::ByteVector(bytes.begin(), bytes.end());
  };
  EXPECT_EQ(outbox.placed()[0].place, here.origin);
  EXPECT_EQ(pack_bytes(outbox.placed()[0]), written(here, k15));
  EXPECT_FALSE(outbox.placed()[1].place.has_value());
  EXPECT_EQ(pack_bytes(outbox.placed()[1]), written(there, k15));
}

TEST(Outbox, SoundsReachEverybodyWithinEarshot) {
  Outbox outbox(k15, 1);
  outbox.write_sound({.attenuation = 2, .entity = 1, .sound = 1, .origin = {1, 2, 3}});
  outbox.write_sound({.attenuation = 0, .entity = 1, .sound = 1, .origin = {1, 2, 3}});
  ASSERT_EQ(outbox.placed().size(), 2u);
  EXPECT_EQ(outbox.placed()[0].place, math::Vec3(1, 2, 3));
  EXPECT_GT(outbox.placed()[0].earshot_units.value(), 500) << "1000 / 2, and a margin";
  EXPECT_LT(outbox.placed()[0].earshot_units.value(), 1200);
  EXPECT_FALSE(outbox.placed()[1].place.has_value()) << "heard everywhere";
}

TEST(Outbox, TheSignonOutlivesTheTick) {
  Outbox outbox(k15, 1);
  for (base::ByteWriter* writer :
       {&outbox.broadcast(), &outbox.reliable(), outbox.reliable_to(vm::EntityIndex{1}), &outbox.signon()})
    outbox.write(net::Nop{}, *writer);
  outbox.write_at_place(net::Nop{}, std::nullopt);
  outbox.clear_tick();
  EXPECT_EQ(outbox.broadcast().size(), 0u);
  EXPECT_EQ(outbox.reliable().size(), 0u);
  EXPECT_EQ(outbox.reliable_to(vm::EntityIndex{1})->size(), 0u);
  EXPECT_TRUE(outbox.placed().empty());
  EXPECT_TRUE(outbox.placed_bytes().empty());
  EXPECT_EQ(outbox.signon().size(), 1u);
}

TEST(Outbox, ABufferIsLimited) {
  Outbox outbox(k15, 1);
  const std::string text(60000, 'a');
  for (int i = 0; i < 40; ++i) outbox.write(net::Print{text}, outbox.reliable());
  EXPECT_LE(outbox.reliable().size(), Outbox::kMaxBytes);
  EXPECT_GT(outbox.reliable().size(), Outbox::kMaxBytes - 2 * text.size());
  // 17 of 60,002 bytes fit.
  EXPECT_EQ(outbox.dropped(), 40u - 17u);
  EXPECT_FALSE(Outbox::has_room(outbox.reliable(), Outbox::kMaxBytes));
  EXPECT_TRUE(Outbox::has_room(outbox.signon(), Outbox::kMaxBytes));
  EXPECT_FALSE(Outbox::has_room(outbox.signon(), std::numeric_limits<std::size_t>::max()));
}

}  // namespace
}  // namespace temblor::server
