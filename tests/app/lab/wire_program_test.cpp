// `temblor lab wire`: tables, JSON, plots, a recorded game, and mistakes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/lab/wire/recorded_game.h"
#include "app/lab/wire/wire_command.h"
#include "app/program.h"
#include "client_server/served_game.h"
#include "support/effort.h"
#include "support/page_markup.h"
#include "support/programs/quakec.h"
#include "support/programs/small_game.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using app::ValueRange;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

ProgramRun run_wire(const std::filesystem::path& folder, const Words& words) {
  Words all{"lab", "wire"};
  all.insert(all.end(), words.begin(), words.end());
  return run_program(folder, all);
}

TEST(WireProgram, PrintsTables) {
  const TemporaryFolder folder;
  const ProgramRun run = run_wire(folder.path(), {"--seconds", "5", "--loss", "2", "--latency", "200"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("Built-in world, 2 players, 5 s at 72 ticks per second, 5 runs of each."));
  EXPECT_THAT(run.out, HasSubstr("\nreliable                    208   417\n"));
  EXPECT_THAT(run.out, HasSubstr("\nwhole-state                  14    28\n"));
  EXPECT_THAT(run.out, HasSubstr("Round trip 200 ms, random loss\n"));
  // All columns end at the same place.
  std::set<std::size_t> widths;
  for (const char* const method :
       {"reliable ", "window ", "whole-state ", "acknowledged-deltas ", "lockstep "}) {
    const std::size_t at = run.out.rfind("\n" + std::string(method));
    ASSERT_NE(at, std::string::npos) << method;
    widths.insert(run.out.find('\n', at + 1) - at);
  }
  EXPECT_EQ(widths.size(), 1u);
}

TEST(WireProgram, PrintsJsonAndDrawsPlots) {
  const TemporaryFolder folder;
  const ProgramRun run =
      run_wire(folder.path(), {"--seconds", "5", "--latency", "0:100", "--loss", kQuick ? "0:1" : "0:10",
                               "--players", "3", "--json", "-o", "x.svg"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result.at("players"), 3);
  EXPECT_EQ(result.at("header_bytes"), 28);
  EXPECT_EQ(result.at("one_lost_packet").size(), 5u * 2 + 2);
  EXPECT_EQ(result.at("random_loss").size(), 5u * 2 * (kQuick ? 2 : 5));
  // Each method sends more than headers, and lockstep to each other peer.
  std::map<std::string, double> bytes;
  for (const json& figures : result.at("random_loss")) {
    EXPECT_GT(figures.at("bytes_in_per_s"), 36 * figures.at("packets_in_per_s").get<double>());
    EXPECT_GE(figures.at("gap_ms").at("max"), figures.at("gap_ms").at("median"));
    EXPECT_GE(figures.at("input_to_picture_ms").at("median"), figures.at("round_trip_ms").get<double>() / 2);
    bytes[figures.at("method")] = figures.at("bytes_in_per_s");
  }
  EXPECT_LT(bytes.at("acknowledged-deltas"), bytes.at("whole-state"));
  const std::string svg = read_text(folder.path() / "x.svg");
  EXPECT_EQ(find_markup_fault("\n" + svg), "");
  EXPECT_THAT(svg, HasSubstr(">lockstep<"));
  EXPECT_THAT(svg, HasSubstr("longest gap, ms"));
  EXPECT_THAT(svg, HasSubstr("KB per second"));
}

TEST(WireProgram, IsListedButDrawsNothing) {
  const TemporaryFolder folder;
  const std::string list = run_program(folder.path(), {"lab", "list"}).out;
  EXPECT_THAT(list, HasSubstr("\nwire: Ways to send a game to its players (`temblor lab wire`)\n"));
  for (const lab::wire::MethodInfo& info : lab::wire::list_methods())
    EXPECT_THAT(list, HasSubstr("\n  " + std::string(info.name) + ": " + std::string(info.summary)));
  for (const Words& words : {Words{"lab", "run", "wire"}, Words{"lab", "compare", "painter", "wire"}}) {
    const ProgramRun run = run_program(folder.path(), words);
    EXPECT_NE(run.exit_status, 0);
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr("wire draws nothing; use `temblor lab wire`"));
  }
}

TEST(WireProgram, MeasuresRoundValuesAndBothEnds) {
  app::WireOptions options;
  const app::WireGrid all = app::make_wire_grid(options);
  EXPECT_THAT(all.losses, ElementsAre(0, 0.01, 0.02, 0.05, 0.1));
  EXPECT_THAT(all.pings_ms, ElementsAre(0, 100, 200, 300));
  options.loss_percent = {3, 3};
  options.latency_ms = {150, 250};
  const app::WireGrid some = app::make_wire_grid(options);
  EXPECT_THAT(some.losses, ElementsAre(0.03));
  EXPECT_THAT(some.pings_ms, ElementsAre(150, 200, 250));
}

// A folder with a small game, in which players have places of their own.
class WireGame {
 public:
  explicit WireGame(std::string_view start_frame = "") {
    std::string program = small_program();
    const auto replace = [&](std::string_view old, std::string_view with) {
      const std::size_t at = program.find(old);
      CHECK(at != std::string::npos);
      program.replace(at, old.size(), with);
    };
    replace("void() StartFrame = {};",
            fmt::format("float joined;\nvoid() StartFrame = {{ {} }};", start_frame));
    replace("setorigin(self, spot.origin + '0 0 1');",
            "setorigin(self, spot.origin + '0 0 1' + '48 0 0' * joined); joined = joined + 1;");
    game_.folder().write("id1/progs/player.mdl", "a server asks only whether it is there");
    game_.folder().write("id1/progs.dat", compile_quakec(program));
  }
  base::Result<lab::wire::World> record(double seconds, const std::string& map = "small") const {
    return app::record_game({.base_folder = game_.path().string(), .games = {}},
                            {.map = map, .seconds = seconds, .players = 3});
  }

 private:
  SmallGame game_;
};

TEST(WireProgram, RecordsARealGame) {
  SKIP_WITHOUT_QUAKEC();
  const WireGame game;
  const auto recorded = game.record(3), again = game.record(3);
  ASSERT_TRUE(recorded.ok()) << recorded.error().message();
  ASSERT_TRUE(again.ok());
  ASSERT_EQ(recorded->ticks.size(), 216u);
  std::size_t moved = 0;
  for (std::size_t tick = 1; tick < recorded->ticks.size(); ++tick) {
    const lab::wire::WorldTick &now = recorded->ticks[tick], &before = recorded->ticks[tick - 1];
    EXPECT_EQ(now.messages, again->ticks[tick].messages) << "the same game each time";
    EXPECT_NEAR(now.time_s - before.time_s, recorded->tick_s, 1e-5) << tick;
    moved += now.state.entities.front().words != before.state.entities.front().words;
  }
  EXPECT_EQ(recorded->ticks.back().state.entities.size(), 4u)
      << "a player sees itself, two others, and a door";
  EXPECT_GT(moved, 50u);
}

TEST(WireProgram, SaysWhichLevelItCannotPlay) {
  SKIP_WITHOUT_QUAKEC();
  const auto recorded = WireGame("if (time > 5) changelevel(\"small\");").record(20);
  ASSERT_FALSE(recorded.ok());
  EXPECT_THAT(recorded.error().message(), HasSubstr("small: the level ends after"));
  const auto missing = WireGame().record(20, "large");
  ASSERT_FALSE(missing.ok());
  EXPECT_THAT(missing.error().message(), HasSubstr("maps/large.bsp"));
}

TEST(WireProgram, ExplainsMistakes) {
  const TemporaryFolder folder;
  struct Mistake {
    Words words;
    const char* message;
  };
  const Mistake mistakes[] = {
      {{"--loss", "51"}, "\"51\" is not N or LOW:HIGH, from 0 to 50"},
      {{"--loss", "5:2"}, "\"5:2\" is not N or LOW:HIGH"},
      {{"--loss", "-1"}, "is not N or LOW:HIGH"},
      {{"--loss", "nan"}, "\"nan\" is not N or LOW:HIGH"},
      {{"--loss", ""}, "--loss"},
      {{"--latency", "1:"}, "\"1:\" is not N or LOW:HIGH, from 0 to 1000"},
      {{"--latency", "0:1001"}, "is not N or LOW:HIGH"},
      {{"--latency", "fast"}, "\"fast\" is not N or LOW:HIGH"},
      {{"--seconds", "4"}, "not in range 5 to 120"},
      {{"--seconds", "121"}, "not in range 5 to 120"},
      {{"--players", "1"}, "not in range 2 to 4"},
      {{"--players", "5"}, "not in range 2 to 4"},
      {{"-o", "x.png"}, "-o x.png: wire writes plots (.svg)"},
      {{"--seconds", "5", "--loss", "0", "--latency", "0", "-o", "nowhere/x.svg"}, "nowhere"},
      {{"--basedir", ".", "--map", "missing"}, "no game folder \"id1\" here"}};
  for (const Mistake& mistake : mistakes) {
    const ProgramRun run = run_wire(folder.path(), mistake.words);
    EXPECT_NE(run.exit_status, 0) << mistake.message;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(mistake.message));
  }
}

}  // namespace
}  // namespace temblor::test
