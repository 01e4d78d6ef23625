#include "server/save/autosave.h"

#include <gtest/gtest.h>

#include <chrono>

#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using server::Autosave;

constexpr double kEvery_s = 180;

// The first time at which a save is due, watched 10 times per second from `from_s` to `to_s`; negative:
// never.
double first_due_s(Autosave& io_autosave, const Autosave::Player& player, double from_s, double to_s) {
  for (double now_s = from_s; now_s < to_s; now_s += 0.1) {
    io_autosave.watch(player, now_s);
    if (io_autosave.is_due(kEvery_s, now_s)) return now_s;
  }
  return -1;
}

TEST(Autosave, IsDueOnArrivalAndEveryFewMinutes) {
  Autosave autosave;
  autosave.begin_level();
  const Autosave::Player well{.health = 100};
  const double first_s = first_due_s(autosave, well, 100, 1000);
  EXPECT_NEAR(first_s, 100.5, 0.2);
  autosave.note_save(first_s);
  EXPECT_NEAR(first_due_s(autosave, well, first_s, 1000), first_s + kEvery_s, 0.2);
  // A save by the player counts, too.
  autosave.note_save(200);
  EXPECT_NEAR(first_due_s(autosave, well, 200, 1000), 200 + kEvery_s, 0.2);
}

TEST(Autosave, WaitsUntilThePlayerIsSafe) {
  Autosave autosave;
  autosave.begin_level();
  EXPECT_LT(first_due_s(autosave, {.health = 100, .stands = false}, 0, 20), 0) << "the player falls";
  autosave.watch({.health = 60}, 20);
  EXPECT_NEAR(first_due_s(autosave, {.health = 60}, 20, 40), 20, 0.2) << "the first, even under attack";
  autosave.note_save(20);
  autosave.watch({.health = 40}, 20 + kEvery_s);
  EXPECT_NEAR(first_due_s(autosave, {.health = 40}, 20 + kEvery_s, 300), 23 + kEvery_s, 0.2)
      << "the player was hit when it was due";
  // Health above the maximum decays automatically.
  autosave.begin_level();
  autosave.watch({.health = 150}, 300);
  autosave.note_save(300);
  for (int i = 0; i < 40; ++i)
    autosave.watch({.health = 150.0f - static_cast<float>(i)}, 296 + kEvery_s + i * 0.1);
  EXPECT_NEAR(first_due_s(autosave, {.health = 110}, 300 + kEvery_s, 600), 300 + kEvery_s, 0.2);
}

TEST(Autosave, ALoadedGameIsSavedAfterTheUsualTime) {
  Autosave autosave;
  autosave.begin_level();
  autosave.begin_loaded("quick");
  EXPECT_NEAR(first_due_s(autosave, {.health = 100}, 0, 1000), kEvery_s, 0.2);
}

TEST(Autosave, ANewGameOverwritesTheOldestOfThree) {
  const TemporaryFolder folder;
  Autosave autosave;
  const auto save = [&] {
    const std::string name = autosave.choose_name(folder.path());
    folder.write(name + ".sav", std::string_view("a game"));
    return name;
  };
  EXPECT_EQ(save(), "autosave");
  EXPECT_EQ(save(), "autosave") << "the same game";
  for (const char* name : {"autosave2", "autosave3"}) {
    autosave.begin_game();
    EXPECT_EQ(save(), name);
  }
  const auto now = std::filesystem::file_time_type::clock::now();
  int age_s = 0;
  for (const char* name : {"autosave.sav", "autosave3.sav", "autosave2.sav"})
    std::filesystem::last_write_time(folder.path() / name, now - std::chrono::seconds(++age_s));
  autosave.begin_game();
  EXPECT_EQ(save(), "autosave2");
  autosave.begin_loaded("autosave3");
  EXPECT_EQ(save(), "autosave3") << "a loaded autosave keeps its name";
}

}  // namespace
}  // namespace temblor::test
