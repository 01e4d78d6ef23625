#include "assets/assets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <set>
#include <utility>

#include "base/text.h"
#include "formats/levels/bsp.h"
#include "formats/levels/lit.h"
#include "vfs/disk.h"

namespace temblor::assets {
namespace {

// A file's bytes and what to call it in a message.
struct NamedBytes {
  std::string name;
  base::ByteVector bytes;
};

// Colored light that fits the level, or none and a note.
std::optional<formats::Lit> fitting_lit(const NamedBytes& file, const formats::Bsp& bsp,
                                        std::vector<std::string>& io_notes) {
  base::Result<formats::Lit> lit = formats::read_lit(file.bytes).with_file(file.name);
  if (!lit.ok()) {
    io_notes.push_back(fmt::format("{}; colored light left out", lit.error().message()));
    return std::nullopt;
  }
  if (lit->samples.size() != bsp.lighting.size() * 3) {
    io_notes.push_back(fmt::format("{}: {} bytes of light, this version of the level wants {}; left out",
                                   file.name, lit->samples.size(), bsp.lighting.size() * 3));
    return std::nullopt;
  }
  return std::move(lit).value();
}

void note_missing_textures(const world::Level& level, std::vector<std::string>& io_notes) {
  constexpr std::size_t kNamesShown = 8;
  std::set<std::string> missing;
  for (const world::Face& face : level.faces)
    if (const world::Texture& texture = level.texture(face.texture); texture.missing)
      missing.insert(texture.name.empty() ? "(no name)" : base::printable(texture.name));
  if (missing.empty()) return;
  std::vector<std::string> shown(missing.begin(), missing.end());
  if (shown.size() > kNamesShown) {
    shown.resize(kNamesShown);
    shown.push_back(fmt::format("and {} more", missing.size() - kNamesShown));
  }
  io_notes.push_back(
      fmt::format("{}: missing textures, drawn as a checker: {}", level.name, fmt::join(shown, ", ")));
}

base::Result<LoadedLevel> make_loaded_level(std::string name, NamedBytes bsp_file,
                                            const std::optional<NamedBytes>& lit_file) {
  TRY(formats::Bsp bsp, formats::read_bsp(bsp_file.bytes).with_file(bsp_file.name));
  bsp_file.bytes = {};  // a large level is not held twice
  LoadedLevel loaded;
  std::optional<formats::Lit> lit;
  if (lit_file) lit = fitting_lit(*lit_file, bsp, loaded.notes);
  TRY(loaded.level,
      world::make_level(std::move(bsp), std::move(name), lit ? &*lit : nullptr).with_file(bsp_file.name));
  note_missing_textures(*loaded.level, loaded.notes);
  return loaded;
}

}  // namespace

base::Result<LoadedLevel> load_level(const vfs::FileSystem& files, std::string_view map_name) {
  const std::string bsp_name = fmt::format("maps/{}.bsp", map_name);
  const std::string lit_name = fmt::format("maps/{}.lit", map_name);
  TRY(base::ByteVector bytes, files.read(bsp_name));
  std::optional<NamedBytes> lit;
  // A .lit of a lower game folder was made for the level that this one hides.
  if (files.contains(lit_name) && files.game_of(lit_name) >= files.game_of(bsp_name)) {
    TRY(base::ByteVector lit_bytes, files.read(lit_name));
    lit = NamedBytes{files.describe(lit_name), std::move(lit_bytes)};
  }
  return make_loaded_level(std::string(map_name), {files.describe(bsp_name), std::move(bytes)}, lit);
}

base::Result<LoadedLevel> load_level_file(const std::filesystem::path& path) {
  TRY(base::ByteVector bytes, vfs::read_disk_file(path));
  std::filesystem::path lit_path = path;
  lit_path.replace_extension(".lit");
  std::optional<NamedBytes> lit;
  if (base::Result<base::ByteVector> lit_bytes = vfs::read_disk_file(lit_path); lit_bytes.ok())
    lit = NamedBytes{lit_path.string(), std::move(lit_bytes).value()};
  else if (lit_bytes.error().code != base::ErrorCode::kNotFound)
    return lit_bytes.error();
  return make_loaded_level(path.stem().string(), {path.string(), std::move(bytes)}, lit);
}

base::Result<Look> load_look(const vfs::FileSystem& files) {
  constexpr std::string_view kPalette = "gfx/palette.lmp";
  constexpr std::string_view kColormap = "gfx/colormap.lmp";
  TRY(const base::ByteVector palette_bytes, files.read(kPalette));
  TRY(const formats::Palette palette,
      formats::read_palette(palette_bytes).with_file(files.describe(kPalette)));
  if (!files.contains(kColormap)) return Look{palette, formats::make_colormap(palette)};
  TRY(const base::ByteVector colormap_bytes, files.read(kColormap));
  TRY(const formats::Colormap colormap,
      formats::read_colormap(colormap_bytes).with_file(files.describe(kColormap)));
  return Look{palette, colormap};
}

}  // namespace temblor::assets
