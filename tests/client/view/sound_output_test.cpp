// Devices that appear and disappear, and music that exists or not, with a fake device.
#include "client/view/sound_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <thread>

#include "formats/sounds/wav.h"
#include "support/programs/small_game.h"

namespace temblor::client {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// State that all devices of a test share.
struct Room {
  bool has_device = true, is_lost = false;
  int opened = 0;
  platform::AudioFill fill;  // of the open device
};

class RoomDevice : public platform::AudioDevice {
 public:
  RoomDevice(Room& room, platform::AudioFill fill) : room_(room) {
    ++room_.opened;
    room_.is_lost = false;
    room_.fill = std::move(fill);
  }
  ~RoomDevice() override { room_.fill = nullptr; }
  int frames_per_second() const override { return 48000; }
  int latency_frames() const override { return 512; }
  bool is_lost() const override { return room_.is_lost; }
  std::string describe() const override { return "a loudspeaker"; }

 private:
  Room& room_;
};

class SoundOutputTest : public ::testing::Test {
 protected:
  SoundOutputTest()
      : output([this](platform::AudioFill fill) -> base::Result<std::unique_ptr<platform::AudioDevice>> {
          if (!room.has_device)
            return base::error(base::ErrorCode::kIo, "no sound device can be opened: gone");
          return std::unique_ptr<platform::AudioDevice>(std::make_unique<RoomDevice>(room, std::move(fill)));
        }) {}
  float loudness() {
    std::vector<float> samples(2 * 1024);
    room.fill(samples);
    return *std::max_element(samples.begin(), samples.end());
  }
  audio::SoundEvents hum() const {
    audio::Sound sound{"hum", std::vector<float>(100, 0.5f), audio::SoundLoop{0, 100}};
    audio::SoundEvents events;
    events.statics.push_back({std::make_shared<const audio::Sound>(sound), {0, 0, 0}, 1, 0});
    return events;
  }

  Room room;
  SoundOutput output;
  audio::Scene scene;
};

TEST_F(SoundOutputTest, PlaysThroughTheDevice) {
  output.advance(0, scene, hum());
  EXPECT_TRUE(output.has_device());
  EXPECT_NEAR(loudness(), 0.5 * 0.7, 1e-3);
  EXPECT_THAT(output.take_notes(), IsEmpty());
}

TEST_F(SoundOutputTest, ReportsAMissingDeviceOnceAndRetries) {
  room.has_device = false;
  for (int i = 0; i < 100; ++i) output.advance(i * 0.1, scene, {});
  EXPECT_FALSE(output.has_device());
  EXPECT_EQ(output.describe(), "no sound device");
  EXPECT_THAT(output.take_notes(), ElementsAre(HasSubstr("gone. Continuing without sound")));
  room.has_device = true;
  for (int i = 100; i < 130; ++i) output.advance(i * 0.1, scene, {});
  EXPECT_TRUE(output.has_device());
  EXPECT_EQ(room.opened, 1);
  EXPECT_THAT(output.take_notes(), ElementsAre("Sound restored: a loudspeaker"));
}

TEST_F(SoundOutputTest, ReplacesALostDeviceAndSoundsContinue) {
  output.advance(0, scene, hum());
  loudness();
  room.is_lost = true;
  room.has_device = false;
  for (int i = 1; i < 50; ++i) output.advance(i * 0.1, scene, {});
  EXPECT_FALSE(output.has_device());
  room.has_device = true;
  for (int i = 50; i < 80; ++i) output.advance(i * 0.1, scene, {});
  ASSERT_TRUE(output.has_device());
  EXPECT_NEAR(loudness(), 0.5 * 0.7, 1e-3);
  EXPECT_THAT(output.take_notes(),
              ElementsAre("Sound device lost (a loudspeaker)", "Sound restored: a loudspeaker"));
}

TEST_F(SoundOutputTest, ReportsDamagedMusicButNotMissingMusic) {
  const test::SmallGame game;
  game.folder().write("id1/music/track03.ogg", "this is no music at all");
  const formats::Wav wav{
      .frames_per_second = 48000, .channels = 1, .bits = 16, .samples = {1, 2}, .loop = {}};
  game.folder().write("id1/music/track05.wav", formats::write_wav(wav));
  game.folder().write("id1/music/track05_combat.ogg", "nor is this");
  const assets::Library library(vfs::FileSystem::open(game.path()).value());
  double time_s = 0;
  // The notes while another thread opens the music: waits for a second at most.
  const auto notes = [&] {
    std::vector<std::string> all;
    for (int i = 0; i < 1000 && all.empty(); ++i) {
      output.advance(time_s += 0.001, scene, {});
      all = output.take_notes();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return all;
  };
  output.play_music(library, 3);
  EXPECT_THAT(notes(), ElementsAre(HasSubstr("track03.ogg: not a playable music file")));
  output.play_music(library, 3);
  output.play_music(library, 5);
  EXPECT_THAT(notes(), ElementsAre(AllOf(HasSubstr("track05_combat.ogg: not a playable music file"),
                                         HasSubstr("Music track 5 plays without it"))));
  output.play_music(library, 2);
  output.play_music(library, 0);
  EXPECT_THAT(notes(), IsEmpty());
}

}  // namespace
}  // namespace temblor::client
