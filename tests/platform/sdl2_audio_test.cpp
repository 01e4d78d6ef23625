// Tests the SDL2 sound device with drivers that need no hardware.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <thread>
#include <vector>

#include "platform/sdl2/audio.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

class SdlAudio : public ::testing::Test {
 protected:
  static void use(const char* driver) { setenv("SDL_AUDIODRIVER", driver, 1); }
  void TearDown() override { unsetenv("SDL_AUDIODRIVER"); }

  // Plays a ramp, so that every frame has a known value.
  base::Result<std::unique_ptr<platform::AudioDevice>> open() {
    return platform::sdl2::open_audio({}, [this](std::span<float> samples) {
      for (std::size_t i = 0; i < samples.size(); i += 2) {
        const auto frame = static_cast<float>(frames_++ % 1000) / 1000;
        samples[i] = frame;
        samples[i + 1] = -frame;
      }
    });
  }
  void wait_for_frames(std::size_t count) const {
    for (int i = 0; i < 10000 && frames_ < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_GE(frames_, count);
  }
  std::atomic<std::size_t> frames_{0};
};

TEST_F(SdlAudio, DummyDeviceAsksForFrames) {
  use("dummy");
  const auto device = open();
  ASSERT_TRUE(device.ok()) << device.error().message();
  EXPECT_EQ((*device)->frames_per_second(), 48000);
  EXPECT_GT((*device)->latency_frames(), 0);
  EXPECT_FALSE((*device)->is_lost());
  EXPECT_THAT((*device)->describe(), HasSubstr("dummy, 48000 frames a second"));
  wait_for_frames(3000);
}

TEST_F(SdlAudio, DestroyedDeviceDoesNotCallBack) {
  use("dummy");
  {
    const auto device = open();
    wait_for_frames(1000);
  }
  const std::size_t frames = frames_;
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(frames_, frames);
}

TEST_F(SdlAudio, DiskDeviceWritesFramesUnchanged) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "sound.raw").string();
  use("disk");
  setenv("SDL_DISKAUDIOFILE", path.c_str(), 1);
  {
    const auto device = open();
    ASSERT_TRUE(device.ok()) << device.error().message();
    wait_for_frames(5000);
  }
  const base::ByteVector bytes = read_file(path);
  std::vector<float> samples(bytes.size() / sizeof(float));
  std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(float));
  // SDL's thread may write silence before the device is unpaused; the ramp itself begins with a silent frame.
  const auto first_sound = std::ranges::find_if(samples, [](float sample) { return sample != 0; });
  const auto begin = static_cast<std::size_t>(first_sound - samples.begin()) - 2;
  ASSERT_GE(samples.size(), begin + 2 * 4000);
  for (std::size_t frame = 0; frame < 4000; ++frame) {
    ASSERT_EQ(samples[begin + 2 * frame], static_cast<float>(frame % 1000) / 1000) << frame;
    ASSERT_EQ(samples[begin + 2 * frame + 1], -samples[begin + 2 * frame]) << frame;
  }
}

TEST_F(SdlAudio, ErrorSaysWhyNoDeviceOpened) {
  use("no-such-driver");
  const auto device = open();
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().code, base::ErrorCode::kIo);
  EXPECT_THAT(device.error().message(), HasSubstr("no sound device can be opened: "));
}

}  // namespace
}  // namespace temblor::test
