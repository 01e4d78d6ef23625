// The player uses another window: the game pauses and is silent. Alt+Enter switches to full screen and back.
#include <gtest/gtest.h>

#include <algorithm>

#include "client_server/served_game.h"
#include "formats/sounds/wav.h"
#include "host/frame/host_parts.h"
#include "host/headless_host.h"
#include "support/programs/quakec.h"

namespace temblor::test {
namespace {

using platform::FocusChanged;
using platform::Key;
using platform::WindowMode;

double game_time_s(HeadlessHost& game) {
  return game.session().server()->game->time_s();
}

TEST(Focus, ASinglePlayerGamePausesWhileAnotherWindowIsInUse) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.run(0.2);
  game.window().put(FocusChanged{false});
  game.run(0.1);
  const double paused_s = game_time_s(game);
  game.run(2);
  EXPECT_EQ(game_time_s(game), paused_s);
  game.window().put(FocusChanged{true});
  game.run(1);
  EXPECT_NEAR(game_time_s(game), paused_s + 1, 0.1);
  game.command("vid_pauseunfocused 0");
  game.window().put(FocusChanged{false});
  game.run(1);
  EXPECT_NEAR(game_time_s(game), paused_s + 2, 0.2);
}

// The menu handles all events while it is open. The focus must not get lost there.
TEST(Focus, IsFollowedWhileAMenuIsOpen) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  for (const bool focused : {false, true}) {
    game.command("togglemenu");
    game.run(0.1);
    game.window().put(FocusChanged{focused});
    game.run(0.1);
    EXPECT_EQ(game.host().input.has_focus, focused);
    game.command("togglemenu");
    game.run(0.1);
  }
}

class SilentDevice : public platform::AudioDevice {
 public:
  int frames_per_second() const override { return 48000; }
  int latency_frames() const override { return 512; }
  bool is_lost() const override { return false; }
  std::string describe() const override { return "a device that a test reads"; }
};

TEST(Focus, SoundIsMutedWhileAnotherWindowIsInUse) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game;
  formats::Wav hum;
  hum.samples.assign(20 * hum.frames_per_second, 100);
  game.folder().write("id1/sound/hum.wav", formats::write_wav(hum));
  game.restart(nullptr, {"map small"});
  platform::AudioFill fill;
  game.host().sound.output.emplace([&](platform::AudioFill from) {
    fill = std::move(from);
    return base::Result<std::unique_ptr<platform::AudioDevice>>(std::make_unique<SilentDevice>());
  });
  const auto loudness = [&] {
    std::vector<float> samples(2 * 4096);
    fill(samples);  // fades
    fill(samples);
    return *std::max_element(samples.begin(), samples.end());
  };
  ASSERT_TRUE(game.run_until_playing());
  game.command("vid_pauseunfocused 0; play hum.wav");
  game.run(0.1);
  ASSERT_TRUE(fill);
  EXPECT_GT(loudness(), 0.05f);
  game.window().put(FocusChanged{false});
  game.run(0.1);
  EXPECT_EQ(loudness(), 0.0f);
  game.command("snd_muteunfocused 0");
  game.run(0.1);
  EXPECT_GT(loudness(), 0.05f);
  game.host().sound.output.reset();
}

TEST(Focus, AltEnterSwitchesToFullScreenAndBack) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  const auto press_enter = [&](bool with_alt) {
    if (with_alt) game.press(Key::kAlt);
    game.press(Key::kEnter);
    game.release(Key::kEnter);
    if (with_alt) game.release(Key::kAlt);
    game.run(0.1);
  };
  press_enter(false);
  EXPECT_EQ(game.window().settings().mode, WindowMode::kWindowed);
  press_enter(true);
  EXPECT_EQ(game.window().settings().mode, WindowMode::kBorderless);
  press_enter(true);
  EXPECT_EQ(game.window().settings().mode, WindowMode::kWindowed);
  game.command("vid_mode fullscreen");
  game.run(0.1);
  press_enter(true);
  EXPECT_EQ(game.window().settings().mode, WindowMode::kWindowed);
  press_enter(true);
  EXPECT_EQ(game.window().settings().mode, WindowMode::kFullScreen);
}

// Alt+Tab: the other window sees the release of Alt.
TEST(Focus, AltIsReleasedWhenFocusIsLost) {
  SKIP_WITHOUT_QUAKEC();
  HeadlessHost game({"map small"});
  ASSERT_TRUE(game.run_until_playing());
  game.press(Key::kAlt);
  game.window().put(FocusChanged{false});
  game.window().put(FocusChanged{true});
  game.press(Key::kEnter);
  game.run(0.1);
  EXPECT_EQ(game.window().settings().mode, WindowMode::kWindowed);
}

}  // namespace
}  // namespace temblor::test
