// Follows the tutorial of docs/mapping.md word for word in an empty folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.h"
#include "artgen/palette.h"
#include "formats/images/png.h"
#include "formats/levels/bsp.h"
#include "support/game_data.h"
#include "support/programs/temporary_folder.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string docs_section() {
  const std::string text = read_text(std::filesystem::path(TEMBLOR_DOCS) / "mapping.md");
  const std::size_t begin = text.find("## From an empty editor"), end = text.find("\n## ", begin);
  return text.substr(begin, end - begin);
}

// Returns the map that the section asks the reader to copy.
std::string first_room() {
  return read_text(std::filesystem::path(TEMBLOR_DOCS) / "examples/first_room.map");
}

// Returns the lines that are commands, in order, without the program's name.
std::vector<std::vector<std::string>> commands_in(const std::string& section) {
  std::vector<std::vector<std::string>> commands;
  std::istringstream lines(section);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("temblor ")) continue;
    std::istringstream words(line.substr(8));
    std::vector<std::string>& command = commands.emplace_back();
    for (std::string word; words >> word;) command.push_back(word);
  }
  return commands;
}

// Returns the share of pixels that are not gray and mostly this channel: 0 red, 1 green, 2 blue.
double measure_share(const Png& picture, std::size_t channel) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.rgb.size(); i += 3) {
    const std::array<int, 3> rgb = {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
    const int most = *std::max_element(rgb.begin(), rgb.end()),
              least = *std::min_element(rgb.begin(), rgb.end());
    count += most > least + 24 && rgb[channel] == most ? 1 : 0;
  }
  return static_cast<double>(count) * 3 / static_cast<double>(picture.rgb.size());
}

TEST(FirstRoom, IsAsTheDocsSay) {
  const std::string section = docs_section();
  const TemporaryFolder folder;
  folder.write("room.map", first_room());
  const auto commands = commands_in(section);
  ASSERT_EQ(commands.size(), 3u);
  for (const std::vector<std::string>& command : commands) {
    const ProgramRun run = run_program(folder.path(), command);
    ASSERT_EQ(run.exit_status, 0) << run.err;
    EXPECT_THAT(run.err, IsEmpty()) << "no texture is missing, nothing leaks";
  }
  const base::ByteVector bytes = read_file(folder.path() / "room.bsp");
  const formats::Bsp bsp = formats::read_bsp(bytes).value();
  EXPECT_EQ(bsp.models.size(), 2u) << "the world and the door";
  EXPECT_THAT(bsp.lighting, Not(IsEmpty()));
  EXPECT_THAT(bsp.visibility, Not(IsEmpty()));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "room.lit"));

  const auto level = world::make_level(bsp, "room").value();
  EXPECT_EQ(world::point_contents(*level, {128, 216, -20}), world::Contents::kWater);
  EXPECT_EQ(world::point_contents(*level, {192, 128, 64}), world::Contents::kSolid) << "the pillar";
  EXPECT_EQ(world::point_contents(*level, {280, 128, 64}), world::Contents::kSky);
  EXPECT_EQ(world::point_contents(*level, {128, -48, 48}), world::Contents::kEmpty) << "the closet";

  const Png room = read_png(folder.path() / "room.png");
  EXPECT_GT(measure_share(room, 0), 0.3) << "bricks and slabs";
  EXPECT_GT(measure_share(room, 2), 0.03) << "sky and water";
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "door.png"));
}

// The two experiments that the docs suggest.
TEST(FirstRoom, LeaksWithoutItsSky) {
  std::string text = first_room();
  const std::size_t sky = text.find("{ // the sky outside the window");
  ASSERT_NE(sky, std::string::npos);
  text.erase(sky, text.find("}\n", sky) + 2 - sky);
  const TemporaryFolder folder;
  folder.write("room.map", text);
  const ProgramRun run = run_program(folder.path(), {"compile", "room.map"});
  EXPECT_THAT(run.err, HasSubstr("leak"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "room.pts"));
}

// A game directory's own textures.wad is used without being named, also by `play --watch`.
TEST(FirstRoom, UsesTexturesOfTheGameDirectory) {
  const TemporaryFolder folder;
  std::string text = first_room();
  for (std::size_t at = text.find(" slabs "); at != std::string::npos; at = text.find(" slabs "))
    text.replace(at, 7, " our_own ");
  folder.write("room.map", text);
  folder.write("base/id1/gfx/palette.lmp", formats::write_palette(artgen::make_palette()));
  const std::vector<std::uint32_t> pixels(16 * 16, 0xff336699);
  folder.write("pictures/our_own.png", formats::write_png(pixels, 16, 16).value());
  const std::vector<std::string> compile = {"--basedir", "base", "compile", "room.map"};
  const ProgramRun without = run_program(folder.path(), compile);
  EXPECT_THAT(without.err, HasSubstr("our_own"));
  const ProgramRun wad = run_program(folder.path(), {"--basedir", "base", "compile", "--textures", "pictures",
                                                     "-o", "base/id1/textures.wad"});
  ASSERT_EQ(wad.exit_status, 0) << wad.err;
  const ProgramRun with = run_program(folder.path(), compile);
  EXPECT_EQ(with.exit_status, 0);
  EXPECT_THAT(with.err, IsEmpty());
}

}  // namespace
}  // namespace temblor::test
