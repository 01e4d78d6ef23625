#include "artgen/art.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <utility>

#include "artgen/level_script/level_maker.h"
#include "artgen/models/model.h"
#include "artgen/palette.h"
#include "artgen/pictures/picture_makers.h"
#include "artgen/scripts/parts.h"
#include "artgen/sounds/music/music_maker.h"
#include "artgen/sounds/sound_maker.h"
#include "artgen/textures/texture.h"
#include "base/text.h"
#include "formats/archives/wad.h"
#include "formats/images/palette.h"

namespace temblor::artgen {
namespace {

struct AssetLine {
  const ScriptFile* file = nullptr;
  const ScriptLine* line = nullptr;
};

// The parts of a file by lump name in lower case; a single entry with an empty name is a plain file. Ordered
// maps, so that the result does not depend on the order of the scripts.
using Lumps = std::map<std::string, ArtPart>;
using Files = std::map<std::string, Lumps>;

// Runs on worker threads: it reads only the script lines.
base::Result<std::vector<ArtPart>> make_asset(const ScriptLine& asset, const Parts& shared) {
  TRY(const ScriptLine whole, expand_parts(asset, shared));
  for (const ArtMaker& maker : art_makers())
    if (maker.keyword == asset.keyword) return maker.make(whole);
  std::string known;
  for (const ArtMaker& maker : art_makers()) known.append(maker.keyword).append(", ");
  return script_error(asset, fmt::format("unknown keyword at the left edge; expected {}part", known));
}

// Adds parts to their files. WAD lump names ignore case, so two that differ only in case are duplicates, too.
base::Status add_parts(const ScriptLine& asset, std::vector<ArtPart> parts, Files& io_files) {
  for (ArtPart& part : parts) {
    Lumps& lumps = io_files[part.path];
    const bool mixed = !lumps.empty() && lumps.begin()->first.empty() != part.lump.empty();
    const std::string lump = base::to_lower(part.lump);
    if (mixed || lumps.contains(lump))
      return script_error(asset, fmt::format("another line already makes {}",
                                             part.lump.empty() ? part.path : part.path + ": " + part.lump));
    lumps.emplace(lump, std::move(part));
  }
  return base::Ok{};
}

// The bytes of a plain file, a text file of all lines, or a WAD of all lumps, ordered by name.
base::Result<base::ByteVector> make_file_bytes(std::string_view path, Lumps lumps) {
  if (lumps.begin()->first.empty()) return std::move(lumps.begin()->second.bytes);
  if (path.ends_with(".txt")) {
    base::ByteVector text;
    for (const auto& [name, line] : lumps) text.insert(text.end(), line.bytes.begin(), line.bytes.end());
    return text;
  }
  std::vector<formats::WadLump> wad;
  for (const auto& [name, part] : lumps) wad.push_back({part.lump, part.lump_type, part.bytes});
  return formats::write_wad(wad);
}

// Every game directory needs these two, whatever its scripts contain.
std::vector<ArtPart> make_palette_parts() {
  const formats::Palette palette = make_palette();
  std::vector<ArtPart> parts;
  parts.push_back({"gfx/palette.lmp", formats::write_palette(palette)});
  parts.push_back({"gfx/colormap.lmp", formats::write_colormap(formats::make_colormap(palette))});
  return parts;
}

}  // namespace

std::span<const ArtMaker> art_makers() {
  static constexpr ArtMaker kMakers[] = {
      {"animation", make_animation}, {"switch", make_switch},
      {"texture", make_texture},     {"level", make_level},
      {"model", make_model_art},     {"font", make_font},
      {"picture", make_picture},     {"wadpicture", make_wad_picture},
      {"pictures", make_pictures},   {"wadpictures", make_wad_pictures},
      {"sprite", make_sprite},       {"icon", make_icon},
      {"mark", make_mark},           {"sound", make_sound_file},
      {"music", make_music_file},
  };
  return kMakers;
}

base::Result<std::vector<ArtFile>> make_art(std::span<const ScriptFile> scripts, base::Jobs& jobs) {
  // Collect parts first, because a script may use a part that a later script defines.
  std::vector<AssetLine> assets;
  Parts shared;
  for (const ScriptFile& script : scripts) {
    for (const ScriptLine& line : script.assets) {
      if (line.keyword == "part")
        TRY_STATUS(add_part(line, shared).with_file(script.name));
      else
        assets.push_back({&script, &line});
    }
  }

  // One slot for each asset, so that threads do not share any state and errors are reported in the scripts'
  // order.
  std::vector<std::optional<base::Result<std::vector<ArtPart>>>> made(assets.size());
  jobs.parallel_for(assets.size(), [&](std::size_t i) { made[i] = make_asset(*assets[i].line, shared); });

  Files files;
  TRY_STATUS(add_parts({}, make_palette_parts(), files));
  for (std::size_t i = 0; i < assets.size(); ++i) {
    const std::string& script = assets[i].file->name;
    TRY(std::vector<ArtPart> parts, std::move(*made[i]).with_file(script));
    TRY_STATUS(add_parts(*assets[i].line, std::move(parts), files).with_file(script));
  }
  std::vector<ArtFile> art;
  for (auto& [path, lumps] : files) {
    TRY(base::ByteVector bytes, make_file_bytes(path, std::move(lumps)).with_file(path));
    art.push_back({path, std::move(bytes)});
  }
  return art;
}

}  // namespace temblor::artgen
