// `temblor lab replay`: a lockstep game, simulated again without a window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "assets/library.h"
#include "client/session/connection.h"
#include "lockstep/lockstep_game.h"
#include "support/game_data.h"
#include "support/programs/small_game.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;

class ReplayProgram : public ::testing::Test {
 protected:
  ReplayProgram() {
    folder().write("id1/progs/player.mdl", "a server asks only whether it is there");
    folder().write("id1/progs.dat", read_file(TEMBLOR_GAME_PROGRAM));
    folder().write("x.replay", play());
  }

  const TemporaryFolder& folder() const { return game_.folder(); }
  ProgramRun run(std::vector<std::string> words) const {
    words.insert(words.begin(), {"--basedir", ".", "lab", "replay"});
    return run_program(folder().path(), words);
  }

 private:
  // Two seconds of a game of one player.
  base::ByteVector play() const {
    auto files = vfs::FileSystem::open(game_.path(), {});
    CHECK(files.ok(), "{}", files.error().message());
    const assets::Library library(std::move(*files));
    std::string version = "Temblor " + run_program(game_.path(), {"--version"}).out;
    version.resize(version.find('\n'));
    lockstep::GameStart start{.program_version = version, .map = "small"};
    CHECK(lockstep::hash_files(library, {}, start).ok());
    const auto game = lockstep::LockstepGame::host({.library = library}, start, nullptr);
    client::Connection client(game->open_client_socket(), {});
    client.connect(game->client_server(), 0);
    for (int i = 0; i < 150; ++i) {
      client.update(i / 72.0);
      game->step(i / 72.0);
    }
    return game->replay()->finish();
  }

  SmallGame game_;
};

TEST_F(ReplayProgram, ChecksTheGameAndWritesADemo) {
  const ProgramRun text = run({"x.replay", "-o", "x.dem"});
  EXPECT_EQ(text.exit_status, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("small, 1 player, 14"));
  EXPECT_THAT(text.out, HasSubstr("the same game as recorded; its last state is "));
  const ProgramRun demo = run_program(folder().path(), {"inspect", "x.dem"});
  EXPECT_THAT(demo.out, HasSubstr("level file: maps/small.bsp")) << demo.err;
  const auto json = nlohmann::json::parse(run({"x.replay", "--json"}).out);
  EXPECT_EQ(json.at("map"), "small");
  EXPECT_NEAR(json.at("seconds").get<double>(), 2, 0.2);
  EXPECT_GT(json.at("kilobytes_per_minute").get<double>(), 0.1);
}

TEST_F(ReplayProgram, ExplainsBadInput) {
  folder().write("bad.replay", std::string_view("no replay"));
  for (const auto& [words, part] :
       {std::pair<std::vector<std::string>, std::string>{{"none.replay"}, "none.replay"},
        {{"bad.replay"}, "bad.replay: this is not a replay"},
        {{"x.replay", "--progs", "bad.replay"}, "progs.dat is not the one here"},
        {{"x.replay", "-o", "none/x.dem"}, "none"}}) {
    const ProgramRun run = this->run(words);
    EXPECT_EQ(run.exit_status, 1) << part;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(part));
  }
  EXPECT_THAT(run({"x.replay", "--player", "2"}).err, HasSubstr("the replay has no player 2"));
}

}  // namespace
}  // namespace temblor::test
