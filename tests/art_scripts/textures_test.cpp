// Checks the shipped textures, which are made from game/art/textures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "artgen/art.h"
#include "artgen/palette.h"
#include "formats/archives/wad.h"
#include "formats/images/wad_texture.h"
#include "support/game_data.h"

namespace temblor::artgen {
namespace {

using Textures = std::map<std::string, formats::WadTexture>;
using Color = std::array<double, 3>;

base::ByteVector make_wad() {
  std::vector<ScriptFile> scripts;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TEMBLOR_SOURCE_DIR) / "game/art/textures")) {
    const base::ByteVector bytes = test::read_file(entry.path());
    base::Result<std::vector<ScriptLine>> lines = read_script(base::as_text(bytes));
    EXPECT_TRUE(lines.ok()) << entry.path();
    if (lines.ok()) scripts.push_back({entry.path().filename().string(), std::move(lines).value()});
  }
  base::Jobs jobs(2);
  const base::Result<std::vector<ArtFile>> art = make_art(scripts, jobs);
  EXPECT_TRUE(art.ok()) << (art.ok() ? "" : art.error().message());
  if (art.ok())
    for (const ArtFile& file : *art)
      if (file.path == "textures.wad") return file.bytes;
  ADD_FAILURE() << "no textures.wad";
  return {};
}

const Textures& shipped() {
  static const Textures textures = [] {
    Textures made;
    const base::ByteVector wad = make_wad();
    const auto lumps = formats::read_wad(wad);
    EXPECT_TRUE(lumps.ok());
    if (!lumps.ok()) return made;
    for (const formats::WadLump& lump : *lumps) {
      const auto texture = formats::read_wad_texture(lump.data);
      EXPECT_TRUE(texture.ok()) << lump.name;
      if (texture.ok()) made[texture->name] = *texture;
    }
    return made;
  }();
  return textures;
}

// Expands "stone1..stone6"; other names stand for themselves.
std::vector<std::string> list_names(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const std::string_view word = list.substr(0, list.find(' '));
    list.remove_prefix(std::min(word.size() + 1, list.size()));
    const std::size_t dots = word.find("..");
    if (dots == std::string_view::npos) {
      names.emplace_back(word);
      continue;
    }
    for (char digit = word[dots - 1]; digit <= word.back(); ++digit)
      names.push_back(std::string(word.substr(0, dots - 1)) + digit);
  }
  return names;
}

TEST(ShippedTextures, IncludeAllThatLevelsName) {
  const std::string_view names =
      "stone1..stone6 cobble1 cobble2 flag1..flag3 rock1..rock3 crystal1 crystal2 gravel1 earth1 moss1 ash1 "
      "brick1..brick5 tile1..tile3 plaster1 plaster2 metal1..metal6 copper1..copper4 rust1 rust2 grate1 "
      "rivet1 "
      "vent1 pipe1 pipe2 hazard1 wood1..wood4 beam1 beam2 crate1 crate2 shelf1 roof1 tech1..tech8 screen1 "
      "wire1 "
      "dial1 trim1..trim6 step1..step3 pillar1 pillar2 door1..door4 door_gold door_silver gate1 "
      "light1..light5 "
      "lamp1 lamp2 window1 window2 sign_exit sign_keys sign_danger sign_t1..sign_t3 sign_tdm1..sign_tdm4 "
      "sign_skill1..sign_skill4 sign_1..sign_11 sign_gallery sky_dusk sky_storm sky_ash *water1 *water2 "
      "*slime1 "
      "*lava1 *tele1 +0forge +1forge +2forge +3forge +0pulse +1pulse +2pulse +3pulse +0screen +1screen "
      "+2screen "
      "+3screen +0drip +1drip +2drip +0button +abutton +0lever +alever {fence1 {grate2 {vine1 {window3 clip "
      "skip "
      "trigger hint origin";
  for (const std::string& name : list_names(names)) EXPECT_TRUE(shipped().contains(name)) << name;
}

TEST(ShippedTextures, AreTheSameEachTime) {
  EXPECT_EQ(make_wad(), make_wad());
}

TEST(ShippedTextures, HaveHolesOnlyInFences) {
  for (const auto& [name, texture] : shipped()) {
    const auto holes = std::count(texture.mips[0].begin(), texture.mips[0].end(), kTransparent);
    if (name.starts_with('{')) {
      // Some texels are visible and some are holes, in every mip level.
      for (const std::vector<std::uint8_t>& mip : texture.mips) {
        const auto open = std::count(mip.begin(), mip.end(), kTransparent);
        EXPECT_LT(open, static_cast<std::int64_t>(mip.size())) << name;
      }
      EXPECT_GT(holes, 0) << name;
    } else {
      for (const std::vector<std::uint8_t>& mip : texture.mips)
        EXPECT_EQ(std::count(mip.begin(), mip.end(), kTransparent), 0) << name;
    }
  }
}

Color color_at(const formats::WadTexture& texture, std::uint32_t x, std::uint32_t y) {
  static const formats::Palette palette = make_palette();
  const formats::Rgb color = palette[texture.mips[0][std::size_t{y} * texture.width + x]];
  return {1.0 * color.r, 1.0 * color.g, 1.0 * color.b};
}

struct Part {
  std::uint32_t left, width;
};

// The mean difference between a column (or row) of a part of a texture and the one before it, which wraps
// around.
double measure_step(const formats::WadTexture& texture, const Part& part, std::uint32_t line,
                    bool is_column) {
  const std::uint32_t lines = is_column ? part.width : texture.height;
  const std::uint32_t length = is_column ? texture.height : part.width;
  const std::uint32_t before = (line + lines - 1) % lines;
  double sum = 0;
  for (std::uint32_t i = 0; i < length; ++i) {
    const Color here =
        is_column ? color_at(texture, part.left + line, i) : color_at(texture, part.left + i, line);
    const Color there =
        is_column ? color_at(texture, part.left + before, i) : color_at(texture, part.left + i, before);
    for (std::size_t c = 0; c < here.size(); ++c) sum += std::abs(here[c] - there[c]);
  }
  return sum / length;
}

// Textures that appear once on a wall and need not tile.
bool is_single(std::string_view name) {
  for (const std::string_view kind :
       {"sign", "door", "crate", "gate", "window", "lamp", "clip", "skip", "trigger", "hint", "origin",
        "+0button", "+abutton", "+0lever", "+alever"})
    if (name.starts_with(kind)) return true;
  return false;
}

// Textures that repeat only horizontally.
bool is_band(std::string_view name) {
  for (const std::string_view kind : {"trim", "step", "pillar"})
    if (name.starts_with(kind)) return true;
  return false;
}

TEST(ShippedTextures, TileWithoutSeams) {
  // A joint at the border may be a little sharper than the others.
  constexpr double kSharper = 1.2;
  for (const auto& [name, texture] : shipped()) {
    if (is_single(name)) continue;
    std::vector<Part> parts = {{0, texture.width}};
    if (name.starts_with("sky")) parts = {{0, texture.width / 2}, {texture.width / 2, texture.width / 2}};
    for (const Part& part : parts)
      for (const bool is_column : {true, false}) {
        if (!is_column && is_band(name)) continue;
        double steepest = 0;
        for (std::uint32_t line = 1; line < (is_column ? part.width : texture.height); ++line)
          steepest = std::max(steepest, measure_step(texture, part, line, is_column));
        EXPECT_LE(measure_step(texture, part, 0, is_column), kSharper * steepest)
            << name << (is_column ? " across" : " down");
      }
  }
}

// The root mean square of each channel: the color that the eye sees of texels that are too small to
// distinguish.
Color average_color(const std::vector<std::uint8_t>& mip) {
  static const formats::Palette palette = make_palette();
  Color sum{};
  double seen = 0;
  for (const std::uint8_t index : mip) {
    if (index == kTransparent) continue;
    const formats::Rgb color = palette[index];
    const std::array<double, 3> channels = {1.0 * color.r, 1.0 * color.g, 1.0 * color.b};
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += channels[c] * channels[c];
    ++seen;
  }
  for (double& channel : sum) channel = seen > 0 ? std::sqrt(channel / seen) : 0;
  return sum;
}

TEST(ShippedTextures, KeepTheirBrightnessAndHueFarAway) {
  for (const auto& [name, texture] : shipped()) {
    const bool shines = std::any_of(texture.mips[0].begin(), texture.mips[0].end(),
                                    [](std::uint8_t index) { return index >= kFirstFullbright; });
    // Lamps can only be rounded to whole texels.
    const double least = shines ? 30 : 10;
    const Color near_by = average_color(texture.mips[0]), far_away = average_color(texture.mips[3]);
    for (std::size_t c = 0; c < near_by.size(); ++c)
      EXPECT_NEAR(near_by[c], far_away[c], least) << name << " channel " << c;
  }
}

TEST(ShippedTextures, AreNeitherFlatNorTooDark) {
  for (const auto& [name, texture] : shipped()) {
    const Color mean = average_color(texture.mips[0]);
    const double brightest = std::max({mean[0], mean[1], mean[2]});
    EXPECT_GT(brightest, 24) << name;
    EXPECT_LT(brightest, 215) << name;
    std::vector<std::uint8_t> colors = texture.mips[0];
    std::sort(colors.begin(), colors.end());
    colors.erase(std::unique(colors.begin(), colors.end()), colors.end());
    EXPECT_GE(colors.size(), 3u) << name;
  }
}

}  // namespace
}  // namespace temblor::artgen
