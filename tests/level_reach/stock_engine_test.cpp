// Another engine plays our levels: QuakeSpasm (Debian's package) loads the shipped game's and a pool whose
// surface once crashed it ("stack smashing detected").
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "compiler/drafts.h"
#include "support/programs/background_program.h"
#include "support/programs/quakespasm_folder.h"

namespace temblor::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr std::array kLevels = {"start", "t1", "t2", "gallery", "pool"};
constexpr const char* kLastLine = "all levels are done";
constexpr auto kLimit = std::chrono::minutes(5);

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

// Enters each level, and walks for a second.
std::string make_script() {
  std::string script = "skill 1\nhost_maxfps 30\n";
  const auto wait = [&](int frames) {
    for (int i = 0; i < frames; ++i) script += "wait\n";
  };
  for (const char* level : kLevels) {
    script += fmt::format("map {}\n", level);
    wait(120);
    script += "+forward\n";
    wait(30);
    script += fmt::format("-forward\necho left {} alive\n", level);
  }
  return script + fmt::format("echo {}\n", kLastLine);
}

// Links everything but what make_quakespasm_folder() writes itself.
void link_levels(const fs::path& id1) {
  fs::create_directories(id1 / "maps");
  for (const auto& entry : fs::directory_iterator(TEMBLOR_GAME "/maps"))
    fs::create_symlink(entry.path(), id1 / "maps" / entry.path().filename());
}

class StockEngine : public ::testing::TestWithParam<const char*> {};

TEST_P(StockEngine, PlaysOurLevels) {
  const std::string engine = GetParam();
  if (!is_installed(engine) || !is_installed("xvfb-run"))
    GTEST_SKIP() << engine << " or a display for it (xvfb, xauth) is not installed";
  const TemporaryFolder home, game;
  fs::create_directory(game.path() / "id1");
  for (const auto& entry : fs::directory_iterator(TEMBLOR_GAME))
    if (entry.path().filename() != "maps" && entry.path().filename() != "progs.dat" &&
        entry.path().filename() != "quake.rc")
      fs::create_symlink(entry.path(), game.path() / "id1" / entry.path().filename());
  link_levels(game.path() / "id1");
  game.write("id1/maps/pool.bsp", base::as_text(make_pool()));
  game.write("id1/walk.cfg", make_script());
  const auto base = make_quakespasm_folder(home, game.path(), TEMBLOR_GAME "/progs.dat");
  if (!base) GTEST_SKIP() << "quakespasm, which has the picture of the registered version, is not installed";
  // Without SDL's signal handlers, it dies at the end of the test instead of writing its settings to the
  // user's home folder. Line by line, its output shows how far it came.
  const BackgroundProgram program(
      {TEMBLOR_SOURCE_DIR "/tests/support/on_display.sh", "320x240x24", "env", "SDL_NO_SIGNAL_HANDLERS=1",
       "stdbuf", "-oL", engine, "-basedir", base->string(), "-window", "-width", "320", "-height", "240",
       "-nosound", "+exec", "walk.cfg"},
      home.path());
  const auto end = std::chrono::steady_clock::now() + kLimit;
  while (std::chrono::steady_clock::now() < end && program.output().find(kLastLine) == std::string::npos)
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const std::string output = program.output();
  std::size_t at = 0;
  for (const char* level : kLevels)
    for (const std::string& line : {std::string("entered the game"), fmt::format("left {} alive", level)}) {
      at = output.find(line, at);
      ASSERT_NE(at, std::string::npos) << "no \"" << line << "\" for " << level << ":\n" << output;
    }
  EXPECT_THAT(output, HasSubstr(kLastLine));
  EXPECT_THAT(output, ::testing::Not(HasSubstr("Host_Error")));
}

INSTANTIATE_TEST_SUITE_P(Engines, StockEngine, ::testing::Values("quakespasm"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace temblor::test
