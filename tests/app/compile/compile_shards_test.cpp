// `temblor compile --shard` and `--merge`: one level made by several processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <utility>

#include "app/compile/compile_program.h"
#include "app/program.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Words = std::vector<std::string>;

TEST_F(CompileProgram, ShardsMakeTheSameLevel) {
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "whole.bsp"}).exit_status, 0);
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "--only", "bsp"}).exit_status, 0);
  const auto run = [&](const Words& words) {
    Words all{"compile", "room.map", "--only"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun done = run_program(folder_.path(), all);
    EXPECT_EQ(done.exit_status, 0) << done.err;
    return done;
  };
  constexpr int kMaxRounds = 8;
  for (int round = 0; round < kMaxRounds; ++round) {
    run({"vis", "--shard", "2/2"});
    run({"vis", "--shard", "1/2"});
    run({"vis", "--merge"});
  }
  EXPECT_THAT(run({"vis", "--merge"}).out, HasSubstr("visibility is complete"));
  for (const char* shard : {"1/3", "2/3", "3/3"}) run({"light", "--shard", shard});
  run({"light", "--merge"});
  EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "whole.bsp"));
  EXPECT_EQ(read_text(folder_.path() / "room.lit"), read_text(folder_.path() / "whole.lit"));
  for (const auto& file : std::filesystem::directory_iterator(folder_.path()))
    EXPECT_THAT(file.path().filename().string(), Not(HasSubstr("-of-")));
}

TEST_F(CompileProgram, MergeReadsOnlyFilesOfShards) {
  folder_.write("room.map", lit_room());
  const std::vector<std::string> others = {"room.light-copy",    "room.light-1-of-2.old", "room.light-0-of-2",
                                           "room.light-3-of-2",  "room.light-01-of-1",    "room.light-1-of-",
                                           "room.lights-1-of-1", "my.room.light-1-of-1"};
  for (const std::string& name : others) folder_.write(name, "no share of light");
  const ProgramRun none = run_program(folder_.path(), {"compile", "room.map", "--only", "light", "--merge"});
  EXPECT_EQ(none.exit_status, 1);
  EXPECT_THAT(none.err, HasSubstr("no shards to merge"));
  for (const Words& words : {Words{"--shard", "1/1"}, Words{"--merge"}}) {
    Words all{"compile", "room.map", "--only", "light"};
    all.insert(all.end(), words.begin(), words.end());
    const ProgramRun run = run_program(folder_.path(), all);
    EXPECT_EQ(run.exit_status, 0) << run.err;
  }
  for (const std::string& name : others)
    EXPECT_EQ(read_text(folder_.path() / name), "no share of light") << name;
}

// The command line is valid; the files are wrong.
TEST_F(CompileProgram, MismatchedShardsAreAFileError) {
  folder_.write("room.map", lit_room());
  const auto run = [&](const char* stage, const Words& words) {
    Words all{"compile", "room.map", "--only", stage};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(folder_.path(), all);
  };
  for (const char* stage : {"vis", "light"}) ASSERT_EQ(run(stage, {"--shard", "1/2"}).exit_status, 0);
  const std::string more_light = entity_text("light", "\"origin\" \"0 0 64\"");
  for (const auto& [stage, map] :
       {std::pair{"vis", hall_of_pillars(2)}, {"light", lit_room() + more_light}}) {
    folder_.write("room.map", map);
    const ProgramRun merged = run(stage, {"--merge"});
    EXPECT_EQ(merged.exit_status, 1) << merged.err;
    EXPECT_THAT(merged.err, HasSubstr(fmt::format("room.{}-1-of-2: ", stage)));
    EXPECT_THAT(merged.err, Not(HasSubstr("--help")));
  }
}

// The script in docs/, with processes instead of machines.
TEST_F(CompileProgram, ScriptForGnuParallelMakesTheSameLevel) {
  if (std::system("command -v parallel >/dev/null") != 0) GTEST_SKIP() << "GNU parallel is not installed";
  folder_.write("room.map", lit_room());
  ASSERT_EQ(run_program(folder_.path(), {"compile", "room.map", "-o", "whole.bsp"}).exit_status, 0);
  std::filesystem::create_directory(folder_.path() / "my programs");
  std::filesystem::create_symlink(TEMBLOR_PROGRAM, folder_.path() / "my programs/temblor 1");
  for (const char* program :
       {TEMBLOR_PROGRAM, "./my programs/temblor 1", TEMBLOR_PROGRAM " --set r_mip_rule=stock"}) {
    const std::string command =
        fmt::format("cd '{}' && TEMBLOR='{}' '{}/compile_with_parallel.sh' 2 room.map >log 2>&1",
                    folder_.path().string(), program, TEMBLOR_DOCS);
    const int status = std::system(command.c_str());
    const std::string log = read_text(folder_.path() / "log");
    ASSERT_EQ(status, 0) << program << log;
    EXPECT_THAT(log, Not(HasSubstr("visibility is complete"))) << "a round without work";
    EXPECT_EQ(read_text(folder_.path() / "room.bsp"), read_text(folder_.path() / "whole.bsp"));
    EXPECT_EQ(read_text(folder_.path() / "room.lit"), read_text(folder_.path() / "whole.lit"));
    for (const char* file : {"room.bsp", "room.lit", "room.build"})
      std::filesystem::remove(folder_.path() / file);
  }
}

// Slurm's sbatch for the script in packaging/: checks the order of the jobs, and runs each at once as Slurm
// would, from a copy of the script.
constexpr const char* kSbatch = R"sh(#!/bin/bash
set -eu
tasks=none
while [[ $1 == --* ]]; do
  case $1 in
    --dependency=afterok:*) [ "${1##*:}" = "$(cat last)" ] || exit 1 ;;
    --array=1-*) tasks=$(seq "${1##*-}" | shuf) ;;
    --parsable | --export=ALL | --job-name=* | --kill-on-invalid-dep=yes | --output=temblor-1.log) ;;
    *) exit 1 ;;
  esac
  shift
done
cp "$1" spooled
shift
for task in $tasks; do
  if [ $task = none ]; then bash spooled "$@"; else SLURM_ARRAY_TASK_ID=$task bash spooled "$@"; fi
done >>jobs.log 2>&1
number=$(($(cat last 2>/dev/null || echo 0) + 1))
echo $number >last
echo "$number;cluster"
)sh";

// Each script starts each shard in up to fourteen rounds, and a process takes long with sanitizers.
TEST_F(CompileProgram, ManyShardsOfALargeMapMakeTheSameLevel) {
  constexpr int kShards = effort(10, 3);
  folder_.write("hall.map", hall_of_pillars(effort(9, 3)));
  ASSERT_EQ(run_program(folder_.path(), {"compile", "hall.map", "-o", "whole.bsp"}).exit_status, 0);
  folder_.write("bin/sbatch", kSbatch);
  std::filesystem::permissions(folder_.path() / "bin/sbatch", std::filesystem::perms::owner_all);
  std::vector<std::string> scripts = {TEMBLOR_SOURCE_DIR "/packaging/compile_with_slurm.sh"};
  if (std::system("command -v parallel >/dev/null") == 0)
    scripts.push_back(TEMBLOR_SOURCE_DIR "/docs/compile_with_parallel.sh");
  for (const std::string& script : scripts) {
    const std::string command =
        fmt::format("cd '{}' && PATH=$PWD/bin:$PATH TEMBLOR='{}' '{}' {} hall.map >log 2>&1",
                    folder_.path().string(), TEMBLOR_PROGRAM, script, kShards);
    ASSERT_EQ(std::system(command.c_str()), 0) << read_text(folder_.path() / "log");
    EXPECT_EQ(read_text(folder_.path() / "hall.bsp"), read_text(folder_.path() / "whole.bsp")) << script;
    for (const char* file : {"hall.bsp", "hall.build"}) std::filesystem::remove(folder_.path() / file);
  }
}

}  // namespace
}  // namespace temblor::test
