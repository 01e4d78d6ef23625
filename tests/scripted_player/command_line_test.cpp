// The exit status of scripted_player: 0 for --help, 2 and one line of explanation for an invalid command
// line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(PlayerCommandLine, InvalidOptionsExitWith2AndHelpWith0) {
  const TemporaryFolder folder;
  const std::string base = folder.path().string();
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"--map", "start"},                                              // no basedir
           {"--basedir", base},                                             // no level
           {"--basedir", base, "--map", "start", "--skill", "9"},           // out of range
           {"--basedir", base, "--map", "start", "--seed", "x"},            // not a number
           {"--basedir", base, "--map", "start", "--waypoints", "1", "2"},  // two of three
           {"--basedir", base, "--map", "start", "--fly"}}) {               // no such option
    const ProgramRun run = run_program(folder.path(), words);
    EXPECT_EQ(run.exit_status, 2) << run.err;
    EXPECT_THAT(run.err, StartsWith("scripted_player: "));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
  const ProgramRun help = run_program(folder.path(), {"--help"});
  EXPECT_EQ(help.exit_status, 0);
  EXPECT_THAT(help.out, HasSubstr("--waypoints"));
}

}  // namespace
}  // namespace temblor::test
