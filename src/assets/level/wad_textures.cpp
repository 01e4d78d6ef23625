#include "assets/level/wad_textures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/text.h"
#include "formats/archives/wad.h"
#include "formats/images/wad3_texture.h"
#include "formats/levels/entities.h"

namespace temblor::assets {
namespace {

bool is_in_a_wad(const formats::BspMiptex& miptex) {
  return miptex.present && !miptex.name.empty() && miptex.mips[0].empty();
}

// Reads the texture from its lump, in the format of the WAD.
base::Result<formats::Wad3Texture> read_wad_lump(const formats::WadLump& lump, bool is_wad3) {
  if (is_wad3) return formats::read_wad3_texture(lump.data);
  formats::Wad3Texture texture;
  TRY(texture.texture, formats::read_wad_texture(lump.data));
  return texture;
}

// Takes the size and texels of the WAD's texture, and its palette if it has one of its own.
base::Status fill(const formats::WadLump& lump, bool is_wad3, formats::BspMiptex& io_miptex) {
  TRY(formats::Wad3Texture found, read_wad_lump(lump, is_wad3));
  io_miptex.width = found.texture.width;
  io_miptex.height = found.texture.height;
  io_miptex.mips = std::move(found.texture.mips);
  if (is_wad3) io_miptex.palette.assign(found.palette.begin(), found.palette.end());
  return base::Ok{};
}

base::Status fill_from(base::Bytes wad, const std::string& file, formats::Bsp& io_bsp,
                       std::vector<std::string>& io_notes) {
  TRY(const std::vector<formats::WadLump> lumps, formats::read_wad(wad));
  const bool is_wad3 = formats::is_wad3(wad);
  for (formats::BspMiptex& miptex : io_bsp.miptexes) {
    if (!is_in_a_wad(miptex)) continue;
    const formats::WadLump* lump = formats::find_lump(lumps, miptex.name);
    if (lump == nullptr) continue;
    if (const base::Status status = fill(*lump, is_wad3, miptex); !status.ok())
      io_notes.push_back(
          fmt::format("{}: \"{}\": {}", file, base::printable(miptex.name), status.error().what));
  }
  return base::Ok{};
}

}  // namespace

std::vector<std::string> list_wads(std::string_view entity_text) {
  const std::vector<formats::Entity> entities = formats::read_faulty_entities(entity_text).entities;
  if (entities.empty()) return {};
  std::string_view value = entities[0].find("wad").value_or(entities[0].find("_wad").value_or(""));
  std::vector<std::string> names;
  while (!value.empty()) {
    const std::size_t end = std::min(value.find(';'), value.size());
    std::string_view name = value.substr(0, end);
    value.remove_prefix(std::min(end + 1, value.size()));
    if (const std::size_t folder = name.find_last_of("/\\:"); folder != std::string_view::npos)
      name.remove_prefix(folder + 1);
    if (!base::to_lower(name).ends_with(".wad") ||
        std::ranges::find(names, base::to_lower(name)) != names.end())
      continue;
    names.push_back(base::to_lower(name));
  }
  return names;
}

void fill_wad_textures(const WadReader& read, formats::Bsp& io_bsp, std::vector<std::string>& io_notes) {
  if (io_bsp.version != formats::BspVersion::k30) return;
  const auto is_complete = [&] { return std::ranges::none_of(io_bsp.miptexes, is_in_a_wad); };
  std::vector<std::string> missing;
  for (const std::string& name : list_wads(io_bsp.entities)) {
    if (is_complete()) return;
    const std::optional<Addition> file = read(name);
    if (!file) {
      missing.push_back(name);
      continue;
    }
    base::Status status = file->bytes.ok() ? fill_from(*file->bytes, file->name, io_bsp, io_notes)
                                           : base::Status(file->bytes.error());
    status = std::move(status).with_file(file->name);
    if (!status.ok())
      io_notes.push_back(fmt::format("{}; its textures are missing", status.error().message()));
  }
  if (!missing.empty() && !is_complete())
    io_notes.push_back(fmt::format(
        "the level's textures are in WADs that are not here: {}; put them into the game folder or wads/",
        fmt::join(missing, ", ")));
}

}  // namespace temblor::assets
