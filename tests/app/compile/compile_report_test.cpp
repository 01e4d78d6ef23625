// `temblor compile --report`: the page is well-formed, and its numbers are those of the level.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "app/compile/compile_program.h"
#include "app/compile/report/level_plan.h"
#include "app/html/html.h"
#include "app/program.h"
#include "formats/images/image.h"
#include "support/game_data.h"
#include "support/levels/room_map.h"
#include "support/page_markup.h"
#include "world/level.h"
#include "world/visibility.h"

namespace temblor::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using Rows = std::vector<std::vector<std::string>>;

// Two rooms, joined by a passage with a bend so that neither sees the other. One has a pillar, which makes
// leaves.
std::string two_rooms() {
  std::string world;
  const auto add = [&](const math::Vec3d& mins, const math::Vec3d& maxs) {
    world += box_text(mins, maxs, "wall");
  };
  add({-16, -16, -16}, {784, 528, 0});
  add({-16, -16, 128}, {784, 528, 144});
  for (const double y : {-16.0, 512.0}) add({-16, y, 0}, {784, y + 16, 128});
  for (const double x : {-16.0, 768.0}) add({x, 0, 0}, {x + 16, 512, 128});
  add({256, 64, 0}, {320, 512, 128});
  add({448, 0, 0}, {512, 448, 128});
  add({100, 200, 0}, {140, 240, 128});
  return entity_text("worldspawn", "\"message\" \"Salt &amp; <b>stone</b>\"", world) +
         point_text("info_player_start", {64, 64, 32}) +
         entity_text("light", "\"origin\" \"64 64 96\"\n\"light\" \"500\"");
}

// Returns the part of the page with that id.
std::string find_section(const std::string& page, const std::string& id) {
  const std::size_t start = page.find("<section id=\"" + id + "\"");
  return start == std::string::npos ? "" : page.substr(start, page.find("</section>", start) - start);
}

// Returns the texts of the cells of all rows, without the heading and without tags.
Rows read_rows(const std::string& page_section) {
  const std::string section = without_pictures(page_section);
  Rows rows;
  const std::regex row("<tr>(.*?)</tr>"), cell("<td[^>]*>(.*?)</td>"), tags("<[^>]*>");
  for (std::sregex_iterator r(section.begin(), section.end(), row), end; r != end; ++r) {
    const std::string cells = (*r)[1];
    std::vector<std::string> texts;
    for (std::sregex_iterator c(cells.begin(), cells.end(), cell); c != end; ++c)
      texts.push_back(std::regex_replace((*c)[1].str(), tags, ""));
    if (!texts.empty()) rows.push_back(texts);
  }
  return rows;
}

std::size_t sum_column(const Rows& rows, std::size_t column) {
  std::size_t sum = 0;
  for (const auto& row : rows) sum += std::stoul(row.at(column));
  return sum;
}

// Returns the bytes of the first PNG in the text.
std::string decode_png(const std::string& text) {
  const std::string mark = "data:image/png;base64,";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (std::size_t i = text.find(mark) + mark.size(); text[i] != '"' && text[i] != '='; ++i) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6 | static_cast<unsigned>(digits.find(text[i]));
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return bytes;
}

class CompileReportTest : public CompileProgram {
 protected:
  std::string compile(const std::string& map, std::vector<std::string> more = {}) {
    folder_.write("room.map", map);
    std::vector<std::string> words{"compile", "room.map", "--report", "room.html"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun run = run_program(folder_.path(), words);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    return read_text(folder_.path() / "room.html");
  }
};

TEST_F(CompileReportTest, IsWellFormedAndComplete) {
  const std::string page = compile(two_rooms());
  EXPECT_EQ(find_markup_fault(page), "");
  for (const char* id : {"problems", "times", "limits", "plan", "light", "lightmaps", "textures"})
    EXPECT_THAT(find_section(page, id), Not(IsEmpty())) << id;
  EXPECT_THAT(find_section(page, "leak"), IsEmpty());
  EXPECT_THAT(page, HasSubstr("Salt &amp;amp; &lt;b&gt;stone&lt;/b&gt;"));
  // It needs no other file.
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"(?!data:)")));
  EXPECT_EQ(find_markup_fault("<!DOCTYPE html>\n<p>&amp;<br/></p>"), "") << "the check itself";
  for (const char* bad : {"<p><b></p></b>", "<p>", "<p class=x></p>", "a < b", "a & b"})
    EXPECT_NE(find_markup_fault(std::string("<!DOCTYPE html>\n") + bad), "") << bad;
}

TEST_F(CompileReportTest, NumbersAreThoseOfTheLevel) {
  const std::string page = compile(two_rooms());
  const formats::Bsp bsp = read_level("room.bsp");
  const Rows limits = read_rows(find_section(page, "limits"));
  const auto used = [&](const char* name) {
    for (const auto& row : limits)
      if (row[0] == name) return std::stoul(row[1]);
    return 0ul;
  };
  EXPECT_EQ(used("faces"), bsp.faces.size());
  EXPECT_EQ(used("clipnodes"), bsp.clipnodes.size());
  EXPECT_EQ(used("bytes of light"), bsp.lighting.size());
  EXPECT_EQ(used("bytes of visibility"), bsp.visibility.size());
  // Each face is in one group of light maps and has one texture. All samples of this level are those of
  // faces.
  const Rows groups = read_rows(find_section(page, "lightmaps"));
  EXPECT_EQ(sum_column(groups, 1), bsp.faces.size());
  EXPECT_EQ(sum_column(groups, 2), bsp.lighting.size());
  const Rows textures = read_rows(find_section(page, "textures"));
  ASSERT_THAT(textures, SizeIs(1));
  EXPECT_EQ(textures[0][1], "wall");
  EXPECT_EQ(std::stoul(textures[0][3]), bsp.faces.size());
  EXPECT_THAT(textures[0][5], HasSubstr("not found"));
  // The histogram.
  const std::string light = find_section(page, "light");
  const std::regex bin("<title>([0-9]+) to ([0-9]+): ([0-9]+) samples");
  std::size_t bins = 0;
  for (std::sregex_iterator found(light.begin(), light.end(), bin), end; found != end; ++found, ++bins) {
    const int low = std::stoi((*found)[1]), high = std::stoi((*found)[2]);
    EXPECT_EQ(std::stol((*found)[3]), std::ranges::count_if(bsp.lighting, [&](std::uint8_t sample) {
                return sample >= low && sample <= high;
              }));
  }
  EXPECT_EQ(bins, 32u);
  EXPECT_THAT(light, HasSubstr(fmt::format("<p>{} samples", bsp.lighting.size())));
}

// Each pixel of the heat map has the color of the most that any leaf below it sees.
TEST_F(CompileReportTest, HeatMapShowsTheVisibilityOfTheLevel) {
  // A room without entities is filled, so it is not on the plan.
  const std::string filled = entity_text("func_group", "", walls_text({900, 0, 0}, {1200, 512, 128}, "wall"));
  const std::string plan = find_section(compile(two_rooms() + filled), "plan");
  const auto level = world::make_level(read_level("room.bsp"), "room").value();
  std::vector<std::uint32_t> seen(level->leaves.size());
  for (std::uint32_t from = 1; from <= level->visible_leaf_count; ++from) {
    std::vector<std::uint8_t> row;
    world::decompress_pvs(*level, world::LeafIndex{from}, row);
    for (std::uint32_t to = 1; to <= level->visible_leaf_count; ++to)
      seen[from] += world::is_in_pvs(row, world::LeafIndex{to}) ? 1 : 0;
  }
  const std::uint32_t largest = std::ranges::max(seen);
  EXPECT_LT(*std::min_element(seen.begin() + 1, seen.begin() + 1 + level->visible_leaf_count), largest);
  const std::string png = decode_png(plan);
  const formats::Image heat = formats::read_png(base::as_bytes(png)).value();
  EXPECT_THAT(plan, HasSubstr("viewBox=\"0 0 832 576\"")) << "768 x 512 and a margin of 32";
  const double left = -32, top = 512 + 32, units_per_px = 832 / 720.0;
  std::size_t open = 0, closed = 0;
  for (std::uint32_t y = 3; y < heat.height; y += 7)
    for (std::uint32_t x = 3; x < heat.width; x += 7) {
      std::uint32_t most = 0;
      for (double z = 0.5; z < 128; ++z) {
        const math::Vec3 at(left + (x + 0.5) * units_per_px, top - (y + 0.5) * units_per_px, z);
        most = std::max(most, seen[base::to_size(world::find_leaf(*level, at))]);
      }
      const std::uint32_t color = heat.pixels[y * heat.width + x];
      if (most == 0) {
        ASSERT_EQ(color >> 24, 0u) << x << " " << y;
      } else {
        ASSERT_EQ(color, app::heat_color(double(most) / largest)) << x << " " << y;
      }
      ++(most == 0 ? closed : open);
    }
  EXPECT_GT(open, 1000u);
  EXPECT_GT(closed, 500u);
  EXPECT_THAT(plan, HasSubstr(fmt::format("sees {} of {} leaves", largest, level->visible_leaf_count)));
}

TEST_F(CompileReportTest, ShowsALeakWithItsPicture) {
  const std::string walls = walls_text({-128, -128, 0}, {128, 128, 128}, "wall");
  const std::string page = compile(entity_text("worldspawn", "", walls.substr(walls.find("}\n") + 2)) +
                                   point_text("info_player_start", {0, 0, 32}));
  EXPECT_EQ(find_markup_fault(page), "");
  const std::string leak = find_section(page, "leak");
  EXPECT_THAT(leak, HasSubstr("Entity 1 (info_player_start) at 0 0 32, line"));
  EXPECT_EQ(decode_png(leak), read_text(folder_.path() / "room.leak.png"));
  EXPECT_THAT(find_section(page, "plan"), HasSubstr("class=\"way\""));
  EXPECT_THAT(find_section(page, "plan"), HasSubstr("has no visibility"));
}

TEST_F(CompileReportTest, WorksForLevelsWithoutLightAndWithoutTheirMap) {
  const std::string bare = compile(lit_room(), {"--no-light", "--no-vis"});
  EXPECT_EQ(find_markup_fault(bare), "");
  EXPECT_THAT(find_section(bare, "light"), HasSubstr("no light maps"));
  const ProgramRun run =
      run_program(folder_.path(), {"compile", "room.bsp", "--only", "vis", "--report", "again.html"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_EQ(find_markup_fault(read_text(folder_.path() / "again.html")), "");
}

TEST_F(CompileReportTest, RefusesNamesOfOtherFiles) {
  folder_.write("room.map", lit_room());
  const ProgramRun run = run_program(folder_.path(), {"compile", "room.map", "--report", "room.map"});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_THAT(run.err, HasSubstr(".html"));
  EXPECT_EQ(read_text(folder_.path() / "room.map"), lit_room());
}

}  // namespace
}  // namespace temblor::test
