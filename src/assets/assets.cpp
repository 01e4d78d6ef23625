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

// The bytes of a file, and its name in messages.
struct NamedBytes {
  std::string name;
  base::ByteVector bytes;
};

// Reads colored light that matches the level. Returns nullopt and adds a note if the file is damaged or was
// made for another version of the level.
std::optional<formats::Lit> read_matching_lit(const NamedBytes& file, const formats::Bsp& bsp,
                                              std::vector<std::string>& io_notes) {
  base::Result<formats::Lit> lit = formats::read_lit(file.bytes).with_file(file.name);
  if (!lit.ok()) {
    io_notes.push_back(fmt::format("{}; colored light is ignored", lit.error().message()));
    return std::nullopt;
  }
  if (lit->samples.size() != bsp.lighting.size() * 3) {
    io_notes.push_back(
        fmt::format("{}: {} bytes of light, but this version of the level needs {}; colored light is ignored",
                    file.name, lit->samples.size(), bsp.lighting.size() * 3));
    return std::nullopt;
  }
  return std::move(lit).value();
}

// Adds one note with the names of all missing textures that a face uses. A level may list textures that no
// face uses; those do not matter.
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
      fmt::format("{}: missing textures, drawn as a checkerboard: {}", level.name, fmt::join(shown, ", ")));
}

// The common end of both ways to load a level: parses the bytes, attaches the light, collects the notes.
base::Result<LoadedLevel> make_loaded_level(std::string name, NamedBytes bsp_file,
                                            const std::optional<NamedBytes>& lit_file) {
  TRY(formats::Bsp bsp, formats::read_bsp(bsp_file.bytes).with_file(bsp_file.name));
  bsp_file.bytes = {};  // do not keep a large level twice
  LoadedLevel loaded;
  std::optional<formats::Lit> lit;
  if (lit_file) lit = read_matching_lit(*lit_file, bsp, loaded.notes);
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
  // A .lit in a lower game folder belongs to the level that this one hides. Stock levels and mods often share
  // names.
  if (files.contains(lit_name) && files.find_game(lit_name) >= files.find_game(bsp_name)) {
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
