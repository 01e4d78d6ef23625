// The scripted player on levels that were not made for Temblor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scripted_player/session/run.h"
#include "support/game_data.h"

namespace temblor::test {
namespace {

class StockLevels : public ::testing::TestWithParam<const char*> {};

// The players cannot be hurt, because this tests routes, not fights.
TEST_P(StockLevels, ArePlayedToTheirExit) {
  DATA_FOLDER_OR_SKIP(data);
  player::RunSetup setup;
  setup.session.base_folder = data;
  setup.session.program_file = TEMBLOR_GAME_PROGRAM;
  setup.session.map = GetParam();
  setup.session.can_cheat = setup.has_god = true;
  const player::RunReport report = player::play_level(setup).value();
  EXPECT_TRUE(report.reached_exit) << player::as_text(report);
}

INSTANTIATE_TEST_SUITE_P(All, StockLevels, ::testing::Values("lq_e0m1", "lq_e0m3", "start_e0"),
                         [](const auto& level) { return std::string(level.param); });

}  // namespace
}  // namespace temblor::test
