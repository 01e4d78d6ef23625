// Sounds by number and name, loaded ahead or on demand.
#include "client/session/sound_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "formats/sounds/wav.h"
#include "support/programs/small_game.h"

namespace temblor::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class SoundTableThreads : public ::testing::Test {
 protected:
  SoundTableThreads() {
    formats::Wav wav{.frames_per_second = 11025, .channels = 1, .bits = 8, .samples = {}, .loop = {}};
    for (int i = 0; i < kSounds; ++i) {
      wav.samples.assign(100 + 10 * static_cast<std::size_t>(i), 20);
      game.folder().write("id1/sound/" + make_name(i), formats::write_wav(wav));
      names.push_back(make_name(i));
    }
    names.push_back("none.wav");
    library.emplace(vfs::FileSystem::open(game.path()).value());
  }
  static std::string make_name(int number) { return "made/" + std::to_string(number) + ".wav"; }

  static constexpr int kSounds = 40;
  test::SmallGame game;
  std::vector<std::string> names = {""};
  std::optional<assets::Library> library;
};

TEST_F(SoundTableThreads, EverySoundIsLoadedOnDemand) {
  SoundTable table(*library);
  table.begin_level(names);
  // From the end, opposite to the order of loading.
  for (int i = kSounds; i > 0; --i) {
    const audio::SoundPtr sound = table.sound(static_cast<std::size_t>(i));
    ASSERT_NE(sound, nullptr) << i;
    EXPECT_EQ(sound->name, make_name(i - 1));
    EXPECT_EQ(table.sound(make_name(i - 1)), sound) << "one shared object";
  }
  EXPECT_EQ(table.sound(0), nullptr);
  EXPECT_EQ(table.sound(1000), nullptr);
}

TEST_F(SoundTableThreads, LoadingAheadReportsNothing) {
  SoundTable table(*library);
  table.begin_level(names);
  for (int i = 0; i < 10000 && table.loaded_count() < kSounds + 1; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(table.loaded_count(), kSounds + 1);
  EXPECT_THAT(table.take_notes(), IsEmpty());
  EXPECT_EQ(table.sound("none.wav"), nullptr);
  EXPECT_THAT(table.take_notes(), ElementsAre(HasSubstr("sound/none.wav: not in")));
}

TEST_F(SoundTableThreads, TheNextLevelKeepsSharedSounds) {
  SoundTable table(*library);
  table.begin_level(names);
  const audio::SoundPtr first = table.sound(1);
  table.begin_level(std::vector<std::string>{"", make_name(7), make_name(0)});
  EXPECT_EQ(table.sound(2), first);
  EXPECT_EQ(table.sound(1)->name, make_name(7));
  EXPECT_EQ(table.sound(3), nullptr);
}

// Each sound has at least some 500 samples at 48 kHz.
TEST_F(SoundTableThreads, FurtherSoundsAreSilentOverTheLimit) {
  SoundTable table(*library, {.ahead_samples = 0, .samples = 5000});
  for (const int level : {1, 2}) {
    table.begin_level(names);
    std::size_t samples = 0;
    int heard = 0;
    for (int i = 0; i < kSounds; ++i)
      if (const audio::SoundPtr sound = table.sound(make_name(i)); sound != nullptr) {
        samples += sound->samples.size();
        ++heard;
      }
    EXPECT_GT(heard, 3) << level;
    EXPECT_LT(samples, 8000u) << level;
    EXPECT_EQ(table.sound(make_name(kSounds - 1)), nullptr);
    EXPECT_NE(table.sound(make_name(0)), nullptr) << "loaded sounds stay";
    EXPECT_THAT(table.take_notes(), ElementsAre(HasSubstr("will be silent")));
    names = {"", make_name(kSounds - 1)};
  }
}

TEST_F(SoundTableThreads, MissingNamesAreLimitedToo) {
  SoundTable table(*library, {.names = 100});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(table.sound("no" + std::to_string(i) + ".wav"), nullptr);
  EXPECT_EQ(table.take_notes().size(), 101u);
}

TEST_F(SoundTableThreads, MayBeDestroyedWhileLoading) {
  for (int i = 0; i < 20; ++i) {
    SoundTable table(*library);
    table.begin_level(names);
    if (i % 2 == 0) table.begin_level(names);
  }
}

}  // namespace
}  // namespace temblor::client
