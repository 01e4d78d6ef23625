// Demos that a client records, played back.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "client/demo/demo_player.h"
#include "client_server/served_game.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

client::DemoPlayer open_recording(base::ByteVector bytes) {
  auto player = client::DemoPlayer::open(std::move(bytes), "recording");
  CHECK(player.ok(), "{}", player.error().message());
  return std::move(player).value();
}

TEST(ClientRecording, ShowsWhatTheClientSaw) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("star");
  served.client(me).start_recording();
  ASSERT_TRUE(served.run_until_playing(me));
  served.run(1, {.angles_deg = {0, 45, 0}, .forward = 200});
  served.client(me).send_command("say for the record");
  served.run(1, {.angles_deg = {10, 135, 0}, .forward = 100});
  EXPECT_TRUE(served.client(me).is_recording());
  const auto bytes = served.client(me).finish_recording();
  ASSERT_TRUE(bytes.has_value());
  EXPECT_FALSE(served.client(me).is_recording());

  client::DemoPlayer player = open_recording(*bytes);
  std::string prints;
  std::size_t packets = 0;
  for (auto goes_on = player.read_packet(); goes_on.ok() && *goes_on; goes_on = player.read_packet()) {
    for (const std::string& text : player.state().events().prints) prints += text;
    player.state().events().clear();
    ++packets;
  }
  EXPECT_FALSE(player.is_truncated());
  EXPECT_GT(packets, 140u);
  EXPECT_THAT(prints, HasSubstr("for the record"));
  const client::Game& seen = served.client(me).state().game();
  const client::Game& played = player.state().game();
  EXPECT_EQ(played.level_name, seen.level_name);
  EXPECT_EQ(played.models, seen.models);
  EXPECT_EQ(played.stats, seen.stats);
  EXPECT_EQ(player.state().time_s(), served.client(me).state().time_s());
  const math::Vec3 looks = player.view_angles_at(player.server_time_s(), {});
  EXPECT_NEAR(looks.x, 10, 1e-3);
  EXPECT_NEAR(looks.y, 135, 1e-3);
}

TEST(ClientRecording, BeginsWithTheNextLevelAndContinuesThroughOthers) {
  SKIP_WITHOUT_QUAKEC();
  ServedGame served;
  const std::size_t me = served.add_client("late");
  ASSERT_TRUE(served.run_until_playing(me));
  served.client(me).start_recording();
  served.run(1);
  EXPECT_FALSE(served.client(me).finish_recording().has_value()) << "no level has started";
  EXPECT_FALSE(served.client(me).finish_recording().has_value()) << "none was started";

  served.client(me).start_recording();
  for (int i = 0; i < 2; ++i) {
    served.command("changelevel small");
    served.run(3);
  }
  const auto bytes = served.client(me).finish_recording();
  ASSERT_TRUE(bytes.has_value());
  const auto length = client::DemoPlayer::scan(*bytes, "recording");
  ASSERT_TRUE(length.ok()) << length.error().message();
  EXPECT_THAT(length->levels, ElementsAre("maps/small.bsp", "maps/small.bsp"));
  EXPECT_FALSE(length->damage.has_value());
}

}  // namespace
}  // namespace temblor::test
