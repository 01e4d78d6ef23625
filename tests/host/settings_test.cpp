// Which settings hold, and which are kept: the player's, the command line's, those of another game.
#include <gtest/gtest.h>

#include "host/played_host.h"
#include "support/game_data.h"
#include "support/quakec.h"

namespace temblor::test {
namespace {

std::string value_of(const PlayedHost& played, std::string_view name) {
  return played.variables().variables().find(name)->text;
}

void quit(PlayedHost& io_played) {
  io_played.command("quit");
  io_played.run(0.1);
}

base::Status on_the_command_line(command::Variables& io_variables) {
  TRY_STATUS(io_variables.set("fov", "110"));
  TRY_STATUS(io_variables.set("sensitivity", "9"));
  return io_variables.set("zoom_fov", "40");
}

TEST(Settings, TheCommandLineHoldsForOneRun) {
  SKIP_WITHOUT_QUAKEC();
  PlayedHost played({"fov 100; sensitivity 5"});
  quit(played);
  played.start_again(on_the_command_line);
  EXPECT_EQ(value_of(played, "fov"), "110");
  EXPECT_EQ(value_of(played, "sensitivity"), "9");
  EXPECT_EQ(value_of(played, "zoom_fov"), "40");
  played.command("sensitivity 6");
  played.command("zoom_speed 4");
  quit(played);
  played.start_again();
  EXPECT_EQ(value_of(played, "fov"), "100") << "as the player had it before";
  EXPECT_EQ(value_of(played, "sensitivity"), "6") << "what he changes himself is his";
  EXPECT_EQ(value_of(played, "zoom_fov"), "30") << "never anything but the default";
  EXPECT_EQ(value_of(played, "zoom_speed"), "4");
}

}  // namespace
}  // namespace temblor::test
