// In the steady state, playing a demo allocates nothing: every operator new of the program is counted.
#include <gtest/gtest.h>

#include "client/console/console_screen.h"
#include "client/demo/demo_builder.h"
#include "client/demo/demo_player.h"
#include "client/session/messages.h"
#include "support/allocation_counter.h"
#include "support/random.h"

namespace temblor::test {
namespace {

base::ByteVector busy_demo(int packets) {
  DemoBuilder demo;
  demo.signon(server_info());
  Random random(1);
  for (int i = 0; i < packets; ++i) {
    const math::Vec3 player = random.in_cube(60), ogre = random.in_cube(200);
    demo.packet(1 + static_cast<float>(i) / 32,
                {net::ClientData{.weapon_frame = static_cast<std::uint16_t>(i % 7), .weapon_model = 3},
                 net::Particles{.count = 20}, net::TempEntity{}, net::Sound{.sound = 1}, net::Damage{},
                 update_at(1, kPlayerModel, player), in_steps(update_at(2, kOgreModel, ogre)),
                 update_at(static_cast<std::uint16_t>(3 + i % 5), kFlameModel, ogre)});
  }
  return demo.bytes();
}

TEST(WarmClient, AllocatesNothing) {
  constexpr int kPackets = 200;
  client::DemoPlayer player = client::DemoPlayer::open(busy_demo(kPackets), "busy.dem").value();
  const client::ClientSettings settings;
  std::size_t entities = 0;
  const auto play_until = [&](double end_s) {
    const std::size_t before = allocation_count();
    for (double time_s = player.packet_time_s(); time_s < end_s; time_s += 1.0 / 72) {
      EXPECT_TRUE(player.advance_to(time_s).value());
      entities += player.state().interpolate_entities(player.server_time_s(), settings).size();
      player.state().events().clear();
    }
    return allocation_count() - before;
  };
  EXPECT_GT(play_until(2), 0u) << "the start must allocate, or the counter is broken";
  EXPECT_EQ(play_until(1 + kPackets / 32.0 - 0.5), 0u);
  EXPECT_GT(entities, 1000u);
}

// The console is closed, with messages over the game.
TEST(WarmConsole, AllocatesNothingOverAGame) {
  ConsoleScreen screen;
  screen.view.settings.notify_time_s = 100;
  screen.ui.print("a message that is longer than a short string, and wrapped in a narrow frame\n", 0);
  screen.draw();
  const std::size_t before = allocation_count();
  for (int frame = 0; frame < 100; ++frame) {
    screen.view.time_s += 0.01;
    EXPECT_FALSE(screen.draw().commands.empty());
  }
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace temblor::test
