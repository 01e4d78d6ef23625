// Other engines play our levels: QuakeSpasm and DarkPlaces (Debian's packages) load the shipped game's and a
// pool whose surface once crashed the first ("stack smashing detected"). Both join by commands in their own
// buffer, so a script that waits there would delay the join. Instead, the engine reads one file of commands
// after another, and the test writes the next one when the output shows that the last one is done.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "compiler/drafts.h"
#include "support/programs/background_program.h"
#include "support/programs/quakespasm_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr std::array kLevels = {"start", "t1", "t2", "gallery", "pool"};
// Much longer than a slow machine needs for one step, such as loading a level.
constexpr auto kLimit = std::chrono::seconds(90);

struct Engine {
  const char* program;
  const char* mode;    // the commands before each level
  const char* joined;  // what it prints when the player is in the level
  const char* pause;   // the commands by which it reads again a little later
};
constexpr Engine kQuakeSpasm = {"quakespasm", "coop 0", "entered the game",
                                "wait; wait; wait; wait; wait; poll"};
// It prints nothing when a player has joined, so the game does, which announces players in a cooperative
// game.
constexpr Engine kDarkPlaces = {"darkplaces", "coop 1", "joined the game", "defer 0.2 poll"};

// A level with gray textures, which other engines need.
base::ByteVector make_pool() {
  formats::Bsp bsp = compile_draft(tiled_pool_text()).draft.bsp;
  for (formats::BspMiptex& texture : bsp.miptexes) {
    texture.present = true;
    texture.width = texture.height = 64;
    for (std::size_t mip = 0; mip < texture.mips.size(); ++mip)
      texture.mips[mip].assign((64u >> mip) * (64u >> mip), 8);
  }
  return formats::write_bsp(bsp, formats::BspVersion::k29).value();
}

// Makes a folder with the shipped game, the pool, and the script that reads the test's commands. Leaves out
// the files that make_quakespasm_folder() writes.
void make_game(const TemporaryFolder& game, std::string_view pause) {
  const fs::path id1 = game.path() / "id1";
  fs::create_directories(id1 / "maps");
  for (const auto& entry : fs::directory_iterator(TEMBLOR_GAME))
    if (const fs::path name = entry.path().filename();
        name != "maps" && name != "progs.dat" && name != "quake.rc")
      fs::create_symlink(entry.path(), id1 / name);
  for (const auto& entry : fs::directory_iterator(TEMBLOR_GAME "/maps"))
    fs::create_symlink(entry.path(), id1 / "maps" / entry.path().filename());
  game.write("id1/maps/pool.bsp", base::as_text(make_pool()));
  game.write("id1/poll.cfg",
             fmt::format("alias poll \"next; {}\"\nalias next \"exec step0.cfg\"\npoll\n", pause));
}

// The base folder for an engine; only QuakeSpasm needs more than the game.
std::optional<fs::path> make_base(const Engine& engine, const TemporaryFolder& home,
                                  const TemporaryFolder& game) {
  make_game(game, engine.pause);
  if (engine.program == std::string(kQuakeSpasm.program))
    return make_quakespasm_folder(home, game.path(), TEMBLOR_GAME "/progs.dat");
  game.write("id1/quake.rc", "stuffcmds\n");
  fs::create_symlink(TEMBLOR_GAME "/progs.dat", game.path() / "id1" / "progs.dat");
  return game.path();
}

// An engine on a display of its own. Without SDL's signal handlers, it dies at the end of the test instead of
// writing its settings. Line by line, its output shows how far it came.
class RunningEngine {
 public:
  // Reads the file "poll.cfg" in the base folder.
  RunningEngine(const Engine& engine, const TemporaryFolder& home, const fs::path& base)
      : id1_(base / "id1"),
        program_({TEMBLOR_SOURCE_DIR "/tests/support/on_display.sh", "320x240x24", "env",
                  "SDL_NO_SIGNAL_HANDLERS=1", "stdbuf", "-oL", engine.program, "-basedir", base.string(),
                  "-window", "-width", "320", "-height", "240", "-nosound", "+exec", "poll.cfg"},
                 home.path()) {}

  // Runs the commands, and waits for a line that contains the text, after the last such line.
  bool has_run(const std::string& commands, const std::string& text) {
    const fs::path file = id1_ / fmt::format("step{}.cfg", step_++);
    std::ofstream(id1_ / "unfinished")
        << fmt::format("alias next \"exec step{}.cfg\"\n{}\n", step_, commands);
    fs::rename(id1_ / "unfinished", file);  // the engine must never read half a file
    const auto end = std::chrono::steady_clock::now() + kLimit;
    while (std::chrono::steady_clock::now() < end) {
      if (const std::size_t at = output().find(text, seen_); at != std::string::npos) {
        seen_ = at + text.size();
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  }
  std::string output() const { return program_.output(); }

 private:
  fs::path id1_;
  BackgroundProgram program_;
  int step_ = 0;
  std::size_t seen_ = 0;  // of the output
};

class StockEngine : public ::testing::TestWithParam<Engine> {};

// Enters each level, and walks for a second.
TEST_P(StockEngine, PlaysOurLevels) {
  const Engine engine = GetParam();
  if (!is_installed(engine.program) || !is_installed("Xvfb"))
    GTEST_SKIP() << engine.program << " or a display for it (xvfb) is not installed";
  const TemporaryFolder home, game;
  const auto base = make_base(engine, home, game);
  if (!base) GTEST_SKIP() << "quakespasm lacks the picture of the registered version";
  RunningEngine running(engine, home, *base);
  for (const std::string level : kLevels) {
    ASSERT_TRUE(running.has_run(fmt::format("{}\nmap {}", engine.mode, level), engine.joined))
        << level << ":\n"
        << running.output();
    ASSERT_TRUE(running.has_run("+forward\necho walks", "walks")) << level << ":\n" << running.output();
    std::this_thread::sleep_for(std::chrono::seconds(1));
    ASSERT_TRUE(running.has_run("-forward\necho left " + level, "left " + level)) << running.output();
  }
  EXPECT_THAT(running.output(), ::testing::Not(HasSubstr("Host_Error")));
}

INSTANTIATE_TEST_SUITE_P(Engines, StockEngine, ::testing::Values(kQuakeSpasm, kDarkPlaces),
                         [](const auto& instance) { return std::string(instance.param.program); });

}  // namespace
}  // namespace temblor::test
