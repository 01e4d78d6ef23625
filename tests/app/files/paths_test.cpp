// Every command that reads or writes files, in folders that are named relative to the current one,
// absolutely, or through a link, and in folders that are read-only.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "app/program.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/programs/background_program.h"
#include "support/programs/small_game.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

// Prints this line if the system does not let a test mount a folder read-only.
constexpr const char* kNoMounts = "no read-only mounts here";

// A folder with a game, a player's home, and an empty folder to start programs in:
//
//   base/id1    palette, level "small", progs.dat      link -> base
//   base/mymod  my.cfg, and where the program writes   elsewhere/
//   home/                                              room.map
class FolderOfGames {
 public:
  FolderOfGames() {
    fs::copy(game_.path(), path() / "base", fs::copy_options::recursive);
    folder_.write("base/mymod/my.cfg", std::string_view("echo mine ran\n"));
    folder_.write("room.map", "{\n\"classname\" \"worldspawn\"\n" +
                                  walls_text({-128, -128, 0}, {128, 128, 128}, "wall") +
                                  "}\n{\n\"classname\" \"info_player_start\"\n\"origin\" \"0 0 24\"\n}\n");
    for (const char* const name : {"home", "elsewhere"}) fs::create_directory(path() / name);
    fs::create_directory_symlink("base", path() / "link");
    if (fs::exists(TEMBLOR_GAME_PROGRAM)) fs::copy_file(TEMBLOR_GAME_PROGRAM, path() / "base/id1/progs.dat");
  }
  const fs::path& path() const { return folder_.path(); }
  fs::path mod() const { return path() / "base/mymod"; }
  fs::path home() const { return path() / "home/.local/share/temblor/mymod"; }

  // Runs a script of the shell in elsewhere/, in which $T is the program. Returns what it prints.
  // `read_only`: a folder that is mounted read-only for the script; empty: none.
  std::string run(const std::string& script, const std::string& read_only = "") const {
    folder_.write("script.sh", script);
    const std::string out = (path() / "out").string();
    const std::string mounting = read_only.empty()
                                     ? ""
                                     : fmt::format("mount --bind {0} {0} && mount -o remount,bind,ro {0} && ",
                                                   (path() / read_only).string());
    // SDL loads and unloads libdbus, which leaks. tests/host finds leaks of the game.
    const std::string words = fmt::format(
        "export ASAN_OPTIONS=detect_leaks=0 HOME={0}/home T={1}; unset XDG_DATA_HOME; ({2}cd {0}/elsewhere) "
        "|| "
        "{{ echo {3}; exit; }}; cd {0}/elsewhere; sh {0}/script.sh",
        path().string(), TEMBLOR_PROGRAM, mounting, kNoMounts);
    folder_.write("start.sh", words);
    const std::string start = (path() / "start.sh").string();
    const std::string line =
        read_only.empty()
            ? fmt::format("sh {} >{} 2>&1 </dev/null", start, out)
            : fmt::format("unshare --map-root-user --mount sh {} >{} 2>&1 </dev/null || echo {} >>{}", start,
                          out, kNoMounts, out);
    if (std::system(line.c_str()) != 0) return "the shell failed\n" + read_text(out);
    return read_text(out);
  }

 private:
  SmallGame game_;
  TemporaryFolder folder_;
};

#define SKIP_WITHOUT_MOUNTS(out) \
  if (out.find(kNoMounts) != std::string::npos) GTEST_SKIP() << "no user namespaces with mounts: " << out

// Writes one file of each kind from a game in a window, and reads them again. `base` names the game's folder.
std::string make_play_script(const std::string& base) {
  return "'" TEMBLOR_SOURCE_DIR
         "/tests/support/on_display.sh"
         "' 1280x1024x24 \"$T\" --basedir " +
         base +
         R"( --game mymod play --nosound --size 160x120 --duration 60 --exec '
host_maxfps 60; sv_autosave 0; alias w "wait; wait; wait; wait; wait; wait; wait; wait; wait; wait"
map small; w; w; w; screenshot; screenshot shots/named; screenshot twice.png; save first; w; w; load first; w; w
record film; w; stop; condump; condump notes.txt; exec my.cfg; sensitivity 5; bind x "echo bound"; writeconfig
demos; saves; flocate my.cfg; w; playdemo film; w; quit'
)";
}

constexpr const char* kWritten[] = {"temblor0000.png", "shots/named.png", "twice.png",
                                    "first.sav",       "first.png",       "film.dem",
                                    "condump.txt",     "notes.txt",       "temblor.cfg"};

#define SKIP_WITHOUT_A_WINDOW()                                                              \
  if (!is_installed("xvfb-run")) GTEST_SKIP() << "a display (xvfb, xauth) is not installed"; \
  if (!fs::exists(TEMBLOR_GAME_PROGRAM))                                                     \
  GTEST_SKIP() << "the game's QuakeC is not compiled: fteqcc is not installed"

TEST(PlayProgram, WritesToTheGameDirectoryHoweverItIsNamed) {
  SKIP_WITHOUT_A_WINDOW();
  const FolderOfGames relative, absolute, linked;
  for (const auto& [games, base] : {std::pair{&relative, std::string("../base/")},
                                    std::pair{&absolute, (absolute.path() / "base").string()},
                                    std::pair{&linked, std::string("../link")}}) {
    const std::string out = games->run(make_play_script(base));
    for (const char* const name : kWritten) {
      EXPECT_TRUE(fs::is_regular_file(games->mod() / name)) << name << "\n" << out;
      const std::string_view file = name;
      if (file != "first.png" && file != "first.sav" && file != "temblor.cfg") {
        EXPECT_THAT(out, HasSubstr(games->mod().filename().string() + "/" + name)) << base;
      }
    }
    EXPECT_EQ(read_png(games->mod() / "shots/named.png").width, 160u);
    EXPECT_THAT(read_text(games->mod() / "temblor.cfg"), HasSubstr("bind x \"echo bound\""));
    EXPECT_THAT(out, HasSubstr("1 saved game\n"));
    EXPECT_THAT(out, HasSubstr("1 demo\n"));
    EXPECT_THAT(out, HasSubstr("mine ran"));
    EXPECT_THAT(out, Not(HasSubstr("cannot")));
    EXPECT_TRUE(fs::is_empty(games->path() / "elsewhere")) << out;
    EXPECT_FALSE(fs::exists(games->home())) << out;
  }
}

TEST(PlayProgram, WritesToTheHomeFolderIfTheGameIsReadOnly) {
  SKIP_WITHOUT_A_WINDOW();
  const FolderOfGames games;
  const std::string out = games.run(make_play_script("../base"), "base");
  SKIP_WITHOUT_MOUNTS(out);
  for (const char* const name : kWritten)
    EXPECT_TRUE(fs::is_regular_file(games.home() / name)) << name << out;
  EXPECT_THAT(out, HasSubstr((games.home() / "temblor0000.png").string()));
  EXPECT_THAT(out, HasSubstr("1 saved game\n"));
  EXPECT_THAT(out, HasSubstr("1 demo\n"));
  EXPECT_THAT(out, HasSubstr("mine ran"));
  EXPECT_THAT(out, Not(HasSubstr("cannot")));
}

// The game goes on, and each command says which file could not be written, and why.
TEST(PlayProgram, NamesTheFileAndTheReasonIfEverythingIsReadOnly) {
  SKIP_WITHOUT_A_WINDOW();
  const FolderOfGames games;
  const std::string out = games.run(make_play_script("../base") + "echo \"ended with $?\"\n", ".");
  SKIP_WITHOUT_MOUNTS(out);
  for (const char* const name : kWritten) {
    if (std::string_view(name) == "first.png") continue;  // follows a saved game
    EXPECT_THAT(out, HasSubstr((games.home() / name).string() + ": cannot write (Read-only file system)"));
  }
  EXPECT_THAT(out, HasSubstr("mine ran"));
  EXPECT_THAT(out, HasSubstr("ended with 0"));
}

// A server console without a player: its files are those that it reads, and the data of game code.
TEST(Paths, ServerReadsItsFilesHoweverTheFolderIsNamed) {
  if (!fs::exists(TEMBLOR_GAME_PROGRAM))
    GTEST_SKIP() << "the game's QuakeC is not compiled: fteqcc is not installed";
  const FolderOfGames games;
  std::ofstream(games.mod() / "server.cfg") << "hostname \"named in server.cfg\"\n";
  const std::string serve =
      " --game mymod serve --port 0 --map small --exec 'hostname; exec my.cfg; status' --exec quit\n";
  for (const std::string& base :
       {std::string("../base/"), (games.path() / "base").string(), std::string("../link")})
    for (const char* const read_only : {"", "base"}) {
      const std::string out = games.run("\"$T\" --basedir " + base + serve, read_only);
      SKIP_WITHOUT_MOUNTS(out);
      EXPECT_THAT(out, HasSubstr("named in server.cfg")) << base << read_only;
      EXPECT_THAT(out, HasSubstr("mine ran")) << base << read_only;
      EXPECT_THAT(out, Not(HasSubstr("cannot"))) << base << read_only;
    }
  const std::string here = games.run("cd ../base; \"$T\"" + serve);
  EXPECT_THAT(here, HasSubstr("named in server.cfg"));
}

// Runs each command that writes a file which the user names. Prints the messages of those that fail.
std::string make_tools_script(const std::string& base, const std::string& output) {
  return fmt::format(R"(
run() {{ "$T" --basedir {0} "$@" >{1}.printed 2>&1 || grep '^temblor: ' {1}.printed; }}
run render --map small --size 64x48 -o {2}/one.png
run render --map small --size 64x48 --frames 2 --turn 5 -o {2}/each-%02d.png
run render --map small --size 64x48 --frames 2 -o {2}/film.y4m
run compile {3}/room.map -o {2}/room.bsp
run compile --textures {3}/pictures -o {2}/room.wad
run inspect {0}/id1/maps/small.bsp
run art {3}/metal.art -o {2}/made
)",
                     base, "$HOME/tool", output, "..");
}

constexpr const char* kMade[] = {"one.png", "each-00.png", "each-01.png", "film.y4m", "room.bsp", "room.wad"};

void write_sources(const FolderOfGames& games) {
  fs::create_directory(games.path() / "pictures");
  const ProgramRun picture = run_program(games.path(), {"--basedir", "base", "render", "--map", "small",
                                                        "--size", "16x16", "-o", "pictures/wall.png"});
  ASSERT_EQ(picture.exit_status, 0) << picture.err;
  std::ofstream(games.path() / "metal.art") << "texture metal 64x64\n  fill slate 0.4\n";
}

TEST(Paths, ToolsWriteWhereTheUserSays) {
  const FolderOfGames games;
  write_sources(games);
  for (const auto& [base, output] :
       {std::pair{std::string("../base/"), std::string("../made")},
        std::pair{(games.path() / "base").string(), (games.path() / "made").string()},
        std::pair{std::string("../link"), std::string("../made-link")}}) {
    fs::remove_all(games.path() / "made");
    fs::create_directory(games.path() / "made");
    if (!fs::is_symlink(games.path() / "made-link"))
      fs::create_directory_symlink("made", games.path() / "made-link");
    EXPECT_EQ(games.run(make_tools_script(base, output)), "");
    for (const char* const name : kMade)
      EXPECT_TRUE(fs::is_regular_file(games.path() / "made" / name)) << name;
    EXPECT_TRUE(fs::is_directory(games.path() / "made/made"));
    EXPECT_TRUE(fs::is_empty(games.path() / "elsewhere"));
  }
}

TEST(Paths, ToolsNameTheFileAndTheReason) {
  const FolderOfGames games;
  write_sources(games);
  const std::string missing = games.run(make_tools_script("../base", "../nowhere"));
  const std::string read_only = games.run(make_tools_script("../base", "../base"), "base");
  SKIP_WITHOUT_MOUNTS(read_only);
  for (const char* const name : {"one.png", "each-00.png", "film.y4m", "room.bsp", "room.wad"}) {
    EXPECT_THAT(missing,
                HasSubstr(fmt::format("temblor: ../nowhere/{}: the folder ../nowhere does not exist", name)));
    EXPECT_THAT(read_only,
                HasSubstr(fmt::format("temblor: ../base/{}: cannot write (Read-only file system)", name)));
  }
  EXPECT_THAT(read_only, HasSubstr("temblor: ../base/made"));
}

}  // namespace
}  // namespace temblor::test
