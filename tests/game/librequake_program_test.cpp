// LibreQuake's own game code, which others wrote and compiled, on all levels of the data.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formats/game/progs.h"
#include "game/played_level.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

using ::testing::IsEmpty;

// Beside the folder of the game data; empty: it is not there.
std::filesystem::path librequake_program(const std::filesystem::path& data) {
  const std::filesystem::path file = data / "../programs/librequake.progs.dat";
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

class LibreQuakeProgram : public ::testing::TestWithParam<std::string> {};

TEST_P(LibreQuakeProgram, PlaysTheLevel) {
  DATA_FOLDER_OR_SKIP(data);
  const std::filesystem::path program = librequake_program(data);
  if (program.empty()) GTEST_SKIP() << "programs/librequake.progs.dat is not beside the folder of the data";
  PlayedLevel game(data, GetParam(), program, {.skill = 2});
  game.join(0);
  for (int second = 0; second < 10; ++second) {
    game.input(0).buttons = static_cast<std::uint8_t>(second % 2 == 0 ? kAttack : kJump);
    game.input(0).command.forward = 400;
    game.input(0).command.view_angles_deg[1] = static_cast<float>(second) * 70;
    game.run(1);
  }
  EXPECT_THAT(game.errors(), IsEmpty());
  EXPECT_THAT(game.unknown_classes(), IsEmpty());
  EXPECT_GT(game.player(0)[server::field::kHealth], -100);
}

INSTANTIATE_TEST_SUITE_P(All, LibreQuakeProgram,
                         ::testing::Values("start", "start_e0", "lq_e0m1", "lq_e0m2", "lq_e0m3", "lq_e1m2",
                                           "lq_end", "lqdm1"));

}  // namespace
}  // namespace temblor::test
