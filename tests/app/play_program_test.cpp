// `temblor play` as players use it: a window on a display (Xvfb), with keys and mouse from the X server.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>

#include "app/compile/compile_program.h"
#include "app/program.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/programs/background_program.h"
#include "support/programs/small_game.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

#define SKIP_WITHOUT_DISPLAY()                                             \
  if (!is_installed("xvfb-run") || !is_installed("xdotool"))               \
    GTEST_SKIP() << "a display (xvfb, xauth) or xdotool is not installed"; \
  if (!std::filesystem::exists(TEMBLOR_GAME_PROGRAM))                      \
  GTEST_SKIP() << "the game's QuakeC is not compiled: fteqcc is not installed"

// A base directory whose last game directory is writable, unless that is forbidden.
class PlaySession {
 public:
  explicit PlaySession(const std::filesystem::path& data) {
    std::filesystem::create_directory_symlink(data / "id1", folder_.path() / "id1");
    folder_.write("evening/autoexec.cfg", std::string_view("host_maxfps 30\n"));
    std::filesystem::copy_file(TEMBLOR_GAME_PROGRAM, game() / "progs.dat");
  }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path game() const { return path() / "evening"; }
  void write(const std::string& name, std::string_view text) const { folder_.write(name, text); }
  // Makes the directory look read-only to the program, even if root runs the test: a folder has the name of
  // the probe file.
  void forbid_writing() const { write("evening/.temblor-may-write/x", "x"); }

  // Runs a script in which PLAY stands for the program. Returns what both print.
  std::string run(std::string script) {
    const std::string play = "'" TEMBLOR_PROGRAM "' --basedir '" + folder_.path().string() +
                             "' --game evening play --nosound --duration 60";
    script.replace(script.find("PLAY --"), 4, play);
    folder_.write("script.sh", script);
    const std::string out = (folder_.path() / "out").string();
    // SDL loads and unloads libdbus, which leaks. tests/host finds leaks of the game.
    const std::string line = "ASAN_OPTIONS=detect_leaks=0; export ASAN_OPTIONS; cd '" +
                             folder_.path().string() +
                             "' && '" TEMBLOR_SOURCE_DIR
                             "/tests/support/on_display.sh"
                             "' 1024x768x24 sh script.sh >'" +
                             out + "' 2>&1";
    status_ = std::system(line.c_str());
    return read_text(out);
  }
  int exit_status() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1; }
  Png picture(const std::string& name) const { return read_png(game() / (name + ".png")); }
  std::string configuration() const { return read_text(game() / "temblor.cfg"); }

 private:
  TemporaryFolder folder_;
  int status_ = -1;
};

// The share of channels that differ by at most 2; 0 if the sizes differ.
double equal_bytes(const Png& a, const Png& b) {
  if (a.rgb.size() != b.rgb.size()) return 0;
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) equal += std::abs(a.rgb[i] - b.rgb[i]) <= 2;
  return static_cast<double>(equal) / static_cast<double>(a.rgb.size());
}

TEST(PlayProgram, PlaysASession) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_DISPLAY();
  PlaySession session(data);
  // The menu, a new game, some steps and shots, a saved game, death, the saved game again, settings, and the
  // end.
  const std::string out = session.run(R"(
type() { xdotool key grave; sleep 0.6; xdotool type --delay 20 "$1"; xdotool key Return; sleep 0.5; xdotool key grave; sleep 1; }
PLAY --size 640x480 & game=$!
xdotool search --sync --name Temblor >/dev/null; sleep 2
xdotool key Return; sleep 0.5; xdotool key Return; sleep 0.5; xdotool key Return; sleep 3
xdotool key F12; sleep 0.5
xdotool keydown w; sleep 0.5; xdotool keyup w
xdotool mousemove_relative 300 0; sleep 0.3
xdotool mousedown 1; sleep 0.4; xdotool mouseup 1; sleep 0.3
xdotool key F12; sleep 0.5
xdotool key F6; sleep 1
type "kill"; sleep 1
xdotool key F12; sleep 0.5
xdotool key F9; sleep 2
xdotool key F12; sleep 0.5
type 'bind x "screenshot bound"'
type "vid_width 800; vid_height 600"
xdotool key grave; sleep 0.6; xdotool type quit; xdotool key Return
wait $game; echo "ended with $?"
)");
  EXPECT_THAT(out, HasSubstr("ended with 0"));
  EXPECT_THAT(out, HasSubstr("Quicksaved"));
  EXPECT_THAT(out, Not(HasSubstr("unknown command")));
  const Png began = session.picture("temblor0000"), turned = session.picture("temblor0001"),
            dead = session.picture("temblor0002"), loaded = session.picture("temblor0003");
  for (const Png* const picture : {&began, &turned, &dead, &loaded}) {
    EXPECT_EQ(picture->width, 640u);
    EXPECT_EQ(picture->height, 480u);
    EXPECT_GT(count_colors(*picture), 300u);
  }
  EXPECT_NE(began, turned);
  EXPECT_NE(dead, turned);
  EXPECT_TRUE(std::filesystem::exists(session.game() / "quick.sav"));
  EXPECT_TRUE(std::filesystem::exists(session.game() / "quick.png"));
  EXPECT_THAT(session.configuration(), HasSubstr("bind x \"screenshot bound\""));

  // The next session.
  const std::string again = session.run(R"(
PLAY --map start & game=$!
xdotool search --sync --name Temblor >/dev/null; sleep 4
xdotool key x; sleep 1
kill -TERM $game
wait $game; echo "ended with $?"
)");
  EXPECT_THAT(again, HasSubstr("ended with 0"));
  const Png bound = session.picture("bound");
  EXPECT_EQ(bound.width, 800u);
  EXPECT_EQ(bound.height, 600u);
}

// OpenGL in the window of the game: the CPU's picture, before and after the window changes.
TEST(PlayProgram, PlaysThroughOpenGl) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_DISPLAY();
  PlaySession session(data);
  session.write("evening/still.cfg", R"(
vid_gl_window on; con_notifylines 0; notarget; host_timescale 0.001
)");
  const std::string out = session.run(R"(
type() { xdotool key grave; sleep 0.6; xdotool type --delay 20 "$1"; xdotool key Return; sleep 0.5; xdotool key grave; sleep 1; }
PLAY --size 640x480 --map start --exec "exec still.cfg" & game=$!
xdotool search --sync --name Temblor >/dev/null; sleep 3
type "screenshot cpu"
type "vid_renderer gl"
type "screenshot gl"
xdotool key alt+Return; sleep 1
type "screenshot full"
xdotool key alt+Return; sleep 1
type "vid_width 800; vid_height 600"
type "screenshot large"
type "vid_renderer cpu"
type "screenshot cpu_again"
xdotool key grave; sleep 0.6; xdotool type quit; xdotool key Return
wait $game; echo "ended with $?"
)");
  EXPECT_THAT(out, HasSubstr("ended with 0"));
  EXPECT_THAT(out, Not(HasSubstr("the CPU draws")));
  const Png cpu = session.picture("cpu"), gl = session.picture("gl"), full = session.picture("full"),
            large = session.picture("large"), cpu_again = session.picture("cpu_again");
  EXPECT_GE(equal_bytes(cpu, gl), 0.98);
  EXPECT_EQ(full.width, 1024u);
  EXPECT_GT(count_colors(full), 300u);
  EXPECT_GE(equal_bytes(large, cpu_again), 0.98);
}

// SDL has no window surface there, and this machine has no graphics hardware, so frames are shown in a third
// way.
TEST(PlayProgram, ShowsPicturesOnWayland) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_DISPLAY();
  if (!is_installed("weston")) GTEST_SKIP() << "a Wayland display (weston) is not installed";
  PlaySession session(data);
  const std::string out = session.run(R"(
export XDG_RUNTIME_DIR="$PWD/run"; mkdir -m 700 run
weston --backend=x11-backend.so --use-pixman --width=900 --height=700 --socket=evening >weston.log 2>&1 & display=$!
for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do [ -S run/evening ] && break; sleep 0.5; done
[ -S run/evening ] || { echo "weston does not start"; cat weston.log; exit; }
export WAYLAND_DISPLAY=evening SDL_VIDEODRIVER=wayland
PLAY --map start --size 640x480 & game=$!
sleep 6
kill -TERM $game
wait $game; echo "ended with $?"
kill $display; wait $display
)");
  if (out.find("weston does not start") != std::string::npos) GTEST_SKIP() << out;
  EXPECT_THAT(out, HasSubstr("Autosaved")) << "on arrival";
  EXPECT_THAT(out, HasSubstr("ended with 0"));
  EXPECT_THAT(out, Not(HasSubstr("the window")));
}

// Game directories are read-only for players of an installed package.
TEST(PlayProgram, CompilesAWatchedMapToAWritableDirectory) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_DISPLAY();
  PlaySession session(data);
  session.forbid_writing();
  session.write("room.map", "{\n\"classname\" \"worldspawn\"\n" +
                                walls_text({-128, -128, 0}, {128, 128, 128}, "wall") +
                                "}\n{\n\"classname\" \"info_player_start\"\n\"origin\" \"0 0 24\"\n}\n");
  const std::string out = session.run(R"(
export XDG_DATA_HOME="$PWD/user"
PLAY --watch room.map & game=$!
xdotool search --sync --name Temblor >/dev/null; sleep 3
printf '{\n"classname" "light"\n"origin" "999 0 0"\n}\n' >>room.map; sleep 4
kill -TERM $game
wait $game; echo "ended with $?"
)");
  EXPECT_THAT(out, HasSubstr("Autosaved")) << "on arrival";
  EXPECT_THAT(out, HasSubstr("reloaded"));
  EXPECT_THAT(out, HasSubstr("temblor: note: "));
  EXPECT_THAT(out, HasSubstr("999 0 0")) << "the console shows the compiler's messages";
  EXPECT_THAT(out, HasSubstr("ended with 0"));
  EXPECT_TRUE(std::filesystem::exists(session.path() / "user/temblor/evening/maps/room.bsp"));
  EXPECT_FALSE(std::filesystem::exists(session.game() / "maps"));
}

// The mapper opens and closes a hole while the game runs.
TEST(PlayProgram, WatchShowsLeaksAndCompilesInFullWhenIdle) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_DISPLAY();
  PlaySession session(data);
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  const auto map = [](const std::string& brushes) {
    return entity_text("worldspawn", "", brushes) + point_text("info_player_start", {0, 0, 24});
  };
  session.write("leak.map", map(walls.substr(walls.find("}\n") + 2)));
  session.write("sealed.map", map(walls));
  const std::string out = session.run(R"(
cp leak.map room.map
PLAY --watch room.map & game=$!
await() { for i in $(seq 300); do [ $(grep -c "$1" out) -ge $2 ] && break; sleep 0.1; done; }
await "room.pts: " 1; echo "the line is shown"
cp sealed.map room.map; await "reloaded" 1; await "Autosaved" 2
echo "sealed"; await "in full" 1; await "visibility" 5
cp leak.map room.map; await "room.pts: " 2
kill -TERM $game
wait $game; echo "ended with $?"
)");
  EXPECT_THAT(out, HasSubstr("the line is shown"));
  const std::size_t sealed = out.find("sealed\n"), full = out.find("Compiling in full...");
  ASSERT_NE(full, std::string::npos) << out;
  EXPECT_LT(sealed, full) << "a level that leaks is not compiled in full";
  EXPECT_THAT(out.substr(full), HasSubstr("room.pts: ")) << "the second leak";
  EXPECT_THAT(out.substr(full), Not(HasSubstr("there is no"))) << out;
  EXPECT_THAT(out, HasSubstr("ended with 0"));
}

// A compilation in full takes long. It must not make the mapper wait.
TEST(PlayProgram, WatchStopsACompilationInFullAfterAChange) {
  DATA_FOLDER_OR_SKIP(data);
  SKIP_WITHOUT_DISPLAY();
  PlaySession session(data);
  session.write("room.map", hall_of_pillars(effort(20, 14)));
  const std::string out = session.run(R"(
PLAY --watch room.map & game=$!
await() { for i in $(seq 600); do [ $(grep -c "$1" out) -ge $2 ] && break; sleep 0.05; done; }
await "in full" 1; sleep 0.3
printf '{\n"classname" "light"\n"origin" "9 9 99"\n}\n' >>room.map
await "reloaded" 1
kill -TERM $game
wait $game; echo "ended with $?"
)");
  const std::size_t full = out.find("Compiling in full...");
  ASSERT_NE(full, std::string::npos) << out;
  const std::string after = out.substr(full, out.find("reloaded") - full);
  EXPECT_THAT(after, HasSubstr("Compiling...\n")) << out;
  EXPECT_EQ(after.find("version 29"), after.rfind("version 29")) << "only the second one made a level";
  EXPECT_THAT(after, Not(HasSubstr("interrupted")));
  EXPECT_THAT(out, HasSubstr("ended with 0"));
}

// Not even by root, who has permission.
TEST(PlayProgram, WritesNothingIntoAnInstalledGame) {
  SKIP_WITHOUT_DISPLAY();
  const SmallGame game;
  const TemporaryFolder prefix;
  std::filesystem::create_directories(prefix.path() / "bin");
  std::filesystem::create_directories(prefix.path() / "share/games");
  std::filesystem::copy_file(TEMBLOR_PROGRAM, prefix.path() / "bin/temblor");
  std::filesystem::copy(game.path(), prefix.path() / "share/games/temblor",
                        std::filesystem::copy_options::recursive);
  prefix.write("home/readme", "");
  const std::string line = "cd '" + prefix.path().string() +
                           "/home' && ASAN_OPTIONS=detect_leaks=0 HOME=\"$PWD\" XDG_DATA_HOME=\"$PWD\" "
                           "XDG_CONFIG_HOME=\"$PWD\" env -u TEMBLOR_DATA '" TEMBLOR_SOURCE_DIR
                           "/tests/support/on_display.sh"
                           "' 1280x1024x24 "
                           "../bin/temblor play --nosound --duration 2 >out 2>&1";
  EXPECT_EQ(std::system(line.c_str()), 0) << read_text(prefix.path() / "home/out");
  EXPECT_TRUE(std::filesystem::exists(prefix.path() / "home/temblor/id1/temblor.cfg"));
  EXPECT_FALSE(std::filesystem::exists(prefix.path() / "share/games/temblor/id1/temblor.cfg"));
}

TEST(PlayProgram, ReportsAMissingDisplay) {
  const SmallGame game;
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const ProgramRun run =
      run_program(game.path(), {"--basedir", game.path().string(), "play", "--nosound", "--duration", "1"});
  EXPECT_EQ(run.exit_status, 1);
  // SDL may print something before it.
  EXPECT_THAT(run.err, HasSubstr("temblor: no display"));
}

TEST(PlayProgram, SaysWhatToDoWithoutGameData) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program_alone(folder.path(), {"play", "--duration", "1"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.err, HasSubstr("--basedir"));
}

}  // namespace
}  // namespace temblor::test
