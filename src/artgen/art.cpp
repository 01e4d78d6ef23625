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

struct Thing {
  const ScriptFile* file = nullptr;
  const ScriptLine* line = nullptr;
};

// Ordered, so that files do not depend on the scripts' order.
using Lumps = std::map<std::string, ArtPart>;
using Files = std::map<std::string, Lumps>;

base::Result<std::vector<ArtPart>> make_thing(const ScriptLine& thing, const Parts& shared) {
  TRY(const ScriptLine whole, with_parts(thing, shared));
  for (const ArtMaker& maker : art_makers())
    if (maker.word == thing.word) return maker.make(whole);
  return script_error(thing, "there is no such kind of things");
}

base::Status add_parts(const ScriptLine& thing, std::vector<ArtPart> parts, Files& io_files) {
  for (ArtPart& part : parts) {
    Lumps& lumps = io_files[part.path];
    const bool mixed = !lumps.empty() && lumps.begin()->first.empty() != part.lump.empty();
    const std::string lump = base::to_lower(part.lump);
    if (mixed || lumps.contains(lump))
      return script_error(thing, fmt::format("another thing is {} already",
                                             part.lump.empty() ? part.path : part.path + ": " + part.lump));
    lumps.emplace(lump, std::move(part));
  }
  return base::Ok{};
}

base::Result<base::ByteVector> bytes_of(Lumps lumps) {
  if (lumps.begin()->first.empty()) return std::move(lumps.begin()->second.bytes);
  std::vector<formats::WadLump> wad;
  for (const auto& [name, part] : lumps) wad.push_back({part.lump, part.lump_type, part.bytes});
  return formats::write_wad(wad);
}

std::vector<ArtPart> palette_parts() {
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
      {"sound", make_sound_file},    {"music", make_music_file},
  };
  return kMakers;
}

base::Result<std::vector<ArtFile>> make_art(std::span<const ScriptFile> scripts, base::Jobs& jobs) {
  std::vector<Thing> things;
  Parts shared;
  for (const ScriptFile& script : scripts) {
    for (const ScriptLine& line : script.things) {
      if (line.word == "part")
        TRY_STATUS(add_part(line, shared).with_file(script.name));
      else
        things.push_back({&script, &line});
    }
  }

  std::vector<std::optional<base::Result<std::vector<ArtPart>>>> made(things.size());
  jobs.parallel_for(things.size(), [&](std::size_t i) { made[i] = make_thing(*things[i].line, shared); });

  Files files;
  TRY_STATUS(add_parts({}, palette_parts(), files));
  for (std::size_t i = 0; i < things.size(); ++i) {
    const std::string& script = things[i].file->name;
    TRY(std::vector<ArtPart> parts, std::move(*made[i]).with_file(script));
    TRY_STATUS(add_parts(*things[i].line, std::move(parts), files).with_file(script));
  }
  std::vector<ArtFile> art;
  for (auto& [path, lumps] : files) {
    TRY(base::ByteVector bytes, bytes_of(std::move(lumps)).with_file(path));
    art.push_back({path, std::move(bytes)});
  }
  return art;
}

}  // namespace temblor::artgen
