// Errors of the program: one line that says what to do, and an exit status.
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.h"
#include "support/effort.h"
#include "support/programs/small_game.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;

void expect_error(const std::filesystem::path& folder, const Words& words, int status,
                  const std::vector<std::string>& parts) {
  const ProgramRun run = run_program(folder, words);
  SCOPED_TRACE(fmt::format("temblor {}", fmt::join(words, " ")));
  EXPECT_EQ(run.exit_status, status);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_THAT(run.out, IsEmpty());
  for (const std::string& part : parts) EXPECT_THAT(run.err, HasSubstr(part));
}

TEST(BadInput, InvalidCommandLinesAreUsageErrors) {
  const TemporaryFolder folder;
  struct Case {
    Words words;
    std::string part;
  };
  const std::vector<Case> cases = {
      {{}, "--help"},
      {{"frobnicate"}, "frobnicate"},
      {{"--frobnicate"}, "--frobnicate"},
      {{"--basedir", "render", "--map", "start", "-o", "x.png"}, "--basedir is followed by"},
      {{"render"}, "--output"},
      {{"render", "-o"}, "--output"},
      {{"render", "-o", "x.jpg"}, ".png"},
      {{"render", "-o", "%s.png"}, "%d"},
      {{"render", "-o", "x.png", "--frames", "2"}, "%05d"},
      {{"render", "-o", "x.png", "--size", "0x5"}, "0x5"},
      {{"render", "-o", "x.png", "--size", "8193x5"}, "8192"},
      {{"render", "-o", "x.png", "--size", "640"}, "WIDTHxHEIGHT"},
      {{"render", "-o", "x.png", "--pos", "1,2"}, "three numbers"},
      {{"render", "-o", "x.png", "--pos", "1,2,nan"}, "three numbers"},
      {{"render", "-o", "x.png", "--color", "pink"}, "indexed"},
      {{"render", "-o", "x.png", "--projection", "fish"}, "orthographic"},
      {{"render", "-o", "x.png", "--fov", "5"}, "--fov"},
      {{"render", "-o", "x.png", "--fov", "nan"}, "--fov"},
      {{"render", "-o", "x.png", "--threads", "-1"}, "--threads"},
      {{"render", "-o", "x.png", "--show", "nothing"}, "depth"},
      {{"render", "-o", "x.png", "--set", "r_nothing=1"}, "r_nothing"},
      {{"render", "-o", "x.png", "--set", "r_simd"}, "NAME=VALUE"},
      {{"render", "-o", "x.png", "--set", "r_simd=maybe"}, "0 or 1"},
      {{"bench", "--json", "--report"}, "--json"},
      {{"bench", "--step", "0"}, "--step"},
      {{"inspect"}, "file"},
      // Options before their command, after another command, or without any command.
      {{"--progs", "x.dat", "play"}, "temblor play --progs"},
      {{"--size", "640x480", "render", "-o", "x.png"}, "temblor render --size"},
      {{"--map=start", "serve"}, "temblor serve --map"},
      {{"--map", "start"}, "temblor play --map"},
      {{"play", "--maxclients", "3"}, "play has no option --maxclients; it belongs to serve"},
      {{"play", "--frobnicate"}, "play has no option --frobnicate"},
  };
  for (const Case& c : cases) expect_error(folder.path(), c.words, 2, {c.part, "--help"});
}

TEST(BadInput, UnknownMapsListSimilarNames) {
  const SmallGame game;
  game.folder().write("id1/maps/b_box.bsp", "a box of ammunition");
  for (const char* command : {"render", "bench"}) {
    Words words = {command, "--basedir", game.path().string(), "--map", "smal"};
    if (words[0] == "render") words.insert(words.end(), {"-o", "x.png"});
    expect_error(game.path(), words, 1, {"maps/smal.bsp", game.path().string(), "similar names: small\n"});
  }
  expect_error(game.path(), {"render", "--map", "../../etc/passwd", "-o", "x.png"}, 1, {"no such level"});
  expect_error(game.path(), {"render", "--map", "nowhere/x.bsp", "-o", "x.png"}, 1, {"nowhere/x.bsp"});
}

TEST(BadInput, MissingDirectoriesNameTheirOption) {
  const TemporaryFolder empty;
  const SmallGame game;
  const ProgramRun alone = run_program_alone(empty.path(), {"render", "--map", "start", "-o", "x.png"});
  EXPECT_EQ(alone.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(alone.err)) << alone.err;
  EXPECT_THAT(alone.err, HasSubstr("--basedir"));
  expect_error(empty.path(), {"render", "--map", "start", "--basedir", "/nowhere", "-o", "x.png"}, 1,
               {"/nowhere", "--basedir"});
  expect_error(empty.path(), {"render", "--map", "start", "--basedir", empty.path().string(), "-o", "x.png"},
               1, {"id1", "--basedir"});
  expect_error(game.path(), {"render", "--game", "nomod", "--map", "small", "-o", "x.png"}, 1,
               {"nomod", "--game"});
}

TEST(BadInput, UnwritableOutputs) {
  const TemporaryFolder folder;
  folder.write("file", "not a folder");
  folder.write("folder.png/inside", "");
  const Words render = {"render", "--size", "8x8", "-o"};
  for (const auto& [out, part] : {std::pair("nowhere/x.png", "the folder nowhere does not exist"),
                                  {"file/x.png", "the folder file does not exist"},
                                  {"folder.png", "cannot write"}}) {
    Words words = render;
    words.emplace_back(out);
    expect_error(folder.path(), words, 1, {out, part, "-o"});
  }
}

// Truncated levels and levels of an unknown version are errors for `render` and `inspect`.
TEST(BadInput, DamagedLevels) {
  const SmallGame game({.tiny = true});
  const base::ByteVector whole = game.level_bytes(formats::BspVersion::k29);
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{60}, whole.size() / 2}) {
    game.folder().write("id1/maps/cut.bsp", base::Bytes(whole).first(size));
    expect_error(game.path(), {"render", "--map", "cut", "-o", "x.png"}, 1, {"maps/cut.bsp"});
    expect_error(game.path(), {"inspect", "id1/maps/cut.bsp"}, 1, {"id1/maps/cut.bsp"});
  }
  base::ByteVector unknown = whole;
  unknown[0] = std::byte{77};
  game.folder().write("id1/maps/cut.bsp", unknown);
  expect_error(game.path(), {"render", "--map", "cut", "-o", "x.png"}, 1, {"maps/cut.bsp", "77"});
}

TEST(BadInput, FlippedBitsNeverCrashTheProgram) {
  const SmallGame game({.tiny = true});
  const base::ByteVector whole = game.level_bytes(formats::BspVersion::kBsp2);
  constexpr int kSeeds = effort(60, 10);
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    Random random(seed);
    base::ByteVector damaged = whole;
    for (int flips = 0; flips < 3; ++flips)
      damaged[random.below(damaged.size())] ^= std::byte(1u << random.below(8));
    game.folder().write("id1/maps/flip.bsp", damaged);
    const ProgramRun run =
        run_program(game.path(), {"render", "--map", "flip", "--size", "32x32", "-o", "x.png"});
    ASSERT_TRUE(run.exit_status == 0 || run.exit_status == 1) << "seed " << seed << ": " << run.err;
    const bool is_note = run.err.starts_with("temblor: note: ");
    EXPECT_EQ(is_one_error_line(run.err) && !is_note, run.exit_status == 1)
        << "seed " << seed << ": " << run.err;
  }
}

TEST(BadInput, DamagedArchivesAndPalettesAreNamed) {
  const SmallGame game;
  game.folder().write("id1/pak0.pak", "PACK, but no more");
  expect_error(game.path(), {"render", "--map", "small", "-o", "x.png"}, 1, {"pak0.pak"});
  const SmallGame other;
  other.folder().write("id1/gfx/palette.lmp", "short");
  expect_error(other.path(), {"render", "--map", "small", "-o", "x.png"}, 1, {"gfx/palette.lmp"});
}

TEST(BadInput, FilesOfUnknownFormats) {
  const TemporaryFolder folder;
  folder.write("notes.txt", "hello");
  folder.write("line\nbreak.xyz", "hello");
  expect_error(folder.path(), {"inspect", "notes.txt"}, 1, {"notes.txt", "known are"});
  expect_error(folder.path(), {"inspect", "line\nbreak.xyz"}, 1, {"line?break.xyz"});
  expect_error(folder.path(), {"inspect", "none.bsp"}, 1, {"none.bsp"});
  expect_error(folder.path(), {"inspect", "."}, 1, {"."});
}

}  // namespace
}  // namespace temblor::test
