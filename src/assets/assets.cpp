#include "assets/assets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <set>
#include <utility>

#include "assets/level/additions.h"
#include "assets/level/external_textures.h"
#include "assets/level/own_palettes.h"
#include "assets/level/wad_textures.h"
#include "base/text.h"
#include "formats/levels/bsp.h"
#include "vfs/disk.h"

namespace temblor::assets {
namespace {

constexpr std::string_view kPalette = "gfx/palette.lmp";

// A server may do without.
std::optional<formats::Palette> read_optional_palette(const vfs::FileSystem& files) {
  if (!files.contains(kPalette)) return std::nullopt;
  const base::Result<base::ByteVector> bytes = files.read(kPalette);
  base::Result<formats::Palette> palette = bytes.ok() ? formats::read_palette(*bytes) : bytes.error();
  return palette.ok() ? std::optional(*palette) : std::nullopt;
}

// Where Half-Life's games and their mods keep WADs, in a game folder.
constexpr std::array<const char*, 4> kWadFolders = {"", "wads/", "textures/wads/", "maps/"};

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

// The common end of both ways to load a level: parses the bytes, applies the files next to it, and collects
// the notes. `file`: its name in messages. `replace_textures` returns the pictures that replace the level's.
template <typename ReplaceTextures>
base::Result<LoadedLevel> make_loaded_level(std::string name, base::ByteVector bytes, const std::string& file,
                                            const AdditionReader& read, const WadReader& read_wad,
                                            const std::optional<formats::Palette>& palette,
                                            ReplaceTextures replace_textures) {
  TRY(formats::Bsp bsp, formats::read_bsp(bytes).with_file(file));
  bytes = {};  // do not keep a large level twice
  LoadedLevel loaded;
  const Additions additions = apply_additions(read, name, bsp, loaded.notes);
  loaded.entities_file = additions.entities_file.empty() ? file : additions.entities_file;
  fill_wad_textures(read_wad, bsp, loaded.notes);
  world::ColoredTextures textures = replace_textures(bsp, loaded.notes);
  if (palette) add_own_palettes(*palette, bsp, textures);
  TRY(loaded.level, world::make_level(std::move(bsp), std::move(name),
                                      additions.lit ? &*additions.lit : nullptr, std::move(textures))
                        .with_file(file));
  for (const std::string& note : loaded.level->notes)
    loaded.notes.push_back(fmt::format("{}: {}", file, note));
  note_missing_textures(*loaded.level, loaded.notes);
  return loaded;
}

}  // namespace

base::Result<LoadedLevel> load_level(const vfs::FileSystem& files, std::string_view map_name,
                                     const LevelOptions& options) {
  const std::string bsp_name = fmt::format("maps/{}.bsp", map_name);
  TRY(base::ByteVector bytes, files.read(bsp_name));
  // A file in a lower game folder belongs to the level that this one hides. Stock levels and mods often share
  // names.
  const auto read = [&](std::string_view suffix) -> std::optional<Addition> {
    const std::string name = fmt::format("maps/{}{}", map_name, suffix);
    if (!files.contains(name) || files.find_game(name) < files.find_game(bsp_name)) return std::nullopt;
    return Addition{files.describe(name), files.read(name)};
  };
  const auto read_wad = [&](std::string_view file_name) -> std::optional<Addition> {
    for (const char* folder : kWadFolders)
      if (const std::string name = fmt::format("{}{}", folder, file_name); files.contains(name))
        return Addition{files.describe(name), files.read(name)};
    return std::nullopt;
  };
  const auto replace_textures = [&](const formats::Bsp& bsp, std::vector<std::string>& io_notes) {
    return options.external_textures ? load_external_textures(files, map_name, bsp, io_notes)
                                     : world::ColoredTextures{};
  };
  return make_loaded_level(std::string(map_name), std::move(bytes), files.describe(bsp_name), read, read_wad,
                           read_optional_palette(files), replace_textures);
}

base::Result<LoadedLevel> load_level_file(const std::filesystem::path& path,
                                          const std::optional<formats::Palette>& palette) {
  TRY(base::ByteVector bytes, vfs::read_disk_file(path));
  const auto read = [&](std::string_view suffix) -> std::optional<Addition> {
    std::filesystem::path file = path;
    file.replace_extension(suffix);
    base::Result<base::ByteVector> content = vfs::read_disk_file(file);
    if (!content.ok() && content.error().code == base::ErrorCode::kNotFound) return std::nullopt;
    return Addition{file.string(), std::move(content)};
  };
  // The folder that holds maps/ is the game's.
  const auto read_wad = [&](std::string_view file_name) -> std::optional<Addition> {
    for (const std::filesystem::path& game : {path.parent_path(), path.parent_path() / ".."})
      for (const char* folder : kWadFolders) {
        const std::filesystem::path file = game / folder / file_name;
        base::Result<base::ByteVector> content = vfs::read_disk_file(file);
        if (content.ok() || content.error().code != base::ErrorCode::kNotFound)
          return Addition{file.string(), std::move(content)};
      }
    return std::nullopt;
  };
  return make_loaded_level(path.stem().string(), std::move(bytes), path.string(), read, read_wad, palette,
                           [](const formats::Bsp&, auto&) { return world::ColoredTextures{}; });
}

base::Result<Look> load_look(const vfs::FileSystem& files) {
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
