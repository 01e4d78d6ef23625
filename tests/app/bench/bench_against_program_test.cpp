// `temblor bench --against` runs another program in turns with ours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/files/child_process.h"
#include "app/program.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using Words = std::vector<std::string>;

// Compares the small built-in level with a command.
ProgramRun bench_against(const TemporaryFolder& folder, const std::string& command, const Words& more = {}) {
  Words words = {"bench", "--size", "64x48", "--step", "180", "--against", command};
  words.insert(words.end(), more.begin(), more.end());
  return run_program(folder.path(), words);
}

TEST(BenchAgainst, PrintsEachRoundAndTheRatio) {
  const TemporaryFolder folder;
  const ProgramRun run = bench_against(folder, "echo 'it took 3 s:'; echo 100.5 fps >&2", {"--rounds", "2"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  const std::string number = "[0-9]+\\.[0-9]+",
                    round = ": " + number + " fps, the command 100\\.5 fps: " + number + " times as fast\n";
  EXPECT_THAT(run.out,
              MatchesRegex("small level: 64x48 rgb, threads: [0-9]+\n  round 1" + round + "  round 2" +
                           round + "  median ratio " + number + ", " + number + " to " + number + "\n"));
}

TEST(BenchAgainst, AddsTheRoundsToJson) {
  const TemporaryFolder folder;
  // Another number in each run: the number of lines so far.
  const std::string command = "echo line >> runs; wc -l < runs";
  const ProgramRun run = bench_against(folder, command, {"--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out), &against = result.at("against");
  EXPECT_EQ(against.at("command"), command);
  EXPECT_EQ(against.at("other_fps"), json({1.0, 2.0, 3.0}));
  ASSERT_EQ(against.at("fps").size(), 3u);
  EXPECT_EQ(against.at("fps")[0], result.at("fps"));
  const json& ratio = against.at("ratio");
  EXPECT_LE(ratio.at("min"), ratio.at("median"));
  EXPECT_LE(ratio.at("median"), ratio.at("max"));
}

TEST(BenchAgainst, GivesTheCommandItsSizeAndName) {
  const TemporaryFolder folder;
  const ProgramRun run = bench_against(folder, "echo \"$1 $2 $3\" >> runs; echo 1",
                                       {"--size", "32x16", "--rounds", "1", "--json"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(json::parse(run.out).size(), 2u);
  EXPECT_EQ(read_text(folder.path() / "runs"), "64 48 small level\n32 16 small level\n");
}

TEST(BenchAgainst, TakesOddOutput) {
  const TemporaryFolder folder;
  for (const char* command :
       {"cat; echo 7",  // standard input is empty
        "head -c 3000000 /dev/zero; echo 7; head -c 9000 /dev/zero", "printf '\\377\\000 7 \\033'",
        "echo 7 'it'\\''s'", "echo 6\necho 7", "sleep 100 & echo 7"}) {
    const ProgramRun run = bench_against(folder, command, {"--rounds", "1", "--json"});
    ASSERT_EQ(run.exit_status, 0) << command << ": " << run.err;
    EXPECT_EQ(json::parse(run.out).at("against").at("other_fps"), json({7.0})) << command;
  }
}

TEST(BenchAgainst, ExplainsFailures) {
  const TemporaryFolder folder;
  const std::pair<const char*, const char*> cases[] = {
      {"exit 3", "the command `exit 3` failed (exit status 3; no output)"},
      {"echo 5; echo no window >&2; exit 4", "failed (exit status 4; last line: no window)"},
      {"no-such-program-anywhere", "(exit status 127; last line: "},
      {"kill -9 $$", "(exit status 137; no output)"},
      {"true", "the command `true` prints no number (exit status 0; no output)"},
      {"echo none", "prints no number (exit status 0; last line: none)"},
      {"echo 0", "prints 0 frames per second, which must be more than 0"},
      {"echo -3", "prints -3 frames per second"},
      {"echo 1,234.5", "prints \"1,234.5\" as its last number"},
      {"yes 1", "prints more than 16 MiB"},
      {"--", "--: "}};
  for (const auto& [command, message] : cases) {
    const ProgramRun run = bench_against(folder, command);
    EXPECT_EQ(run.exit_status, 1) << command;
    EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(message));
  }
}

TEST(BenchAgainst, ChecksItsOptions) {
  const TemporaryFolder folder;
  for (const Words& words : {Words{"bench", "--rounds", "2"}, Words{"bench", "--against", " "},
                             Words{"bench", "--against", "echo 1", "--report"},
                             Words{"bench", "--against", "echo 1", "--rounds", "101"}})
    EXPECT_EQ(run_program(folder.path(), words).exit_status, 2);
}

// Waits for at most 20 s until `condition` is true.
template <typename Condition>
bool becomes_true(const Condition& condition) {
  for (int i = 0; i < 2000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return condition();
}

TEST(BenchAgainst, InterruptionEndsTheCommand) {
  const TemporaryFolder folder;
  const std::filesystem::path pids = folder.path() / "pids";
  const auto read_pids = [&] {
    std::ifstream file(pids);
    std::vector<int> numbers;
    for (int number = 0; file >> number;) numbers.push_back(number);
    return numbers;
  };
  // The shell, and a program that it waits for.
  auto bench = app::ChildProcess::start({TEMBLOR_PROGRAM, "bench", "--size", "64x48", "--against",
                                         "sleep 1000 & echo $$ $! >> " + pids.string() + "; wait"});
  ASSERT_TRUE(bench.ok()) << bench.error().message();
  ASSERT_TRUE(becomes_true([&] { return read_pids().size() == 2; }));
  bench->terminate();
  const base::Status ended = bench->finish();
  ASSERT_FALSE(ended.ok());
  EXPECT_THAT(ended.error().what, HasSubstr("interrupted"));
  // An orphan that nobody waits for has ended, but keeps its number.
  for (const int pid : read_pids()) {
    const auto has_ended = [&] {
      std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
      std::string number, name, state;
      return !(file >> number >> name >> state) || state == "Z";
    };
    EXPECT_TRUE(becomes_true(has_ended)) << pid;
  }
}

}  // namespace
}  // namespace temblor::test
