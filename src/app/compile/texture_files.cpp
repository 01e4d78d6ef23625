#include "app/compile/texture_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <system_error>
#include <utility>

#include "app/files/game_files.h"
#include "artgen/palette.h"
#include "artgen/small_level.h"
#include "base/text.h"
#include "compiler/make_wad.h"
#include "compiler/wad_paths.h"
#include "formats/archives/wad.h"
#include "formats/images/wad_texture.h"
#include "formats/levels/bsp.h"
#include "vfs/disk.h"

namespace temblor::app {
namespace {

namespace fs = std::filesystem;

// Finds the PNG files of a folder, sorted by name.
base::Result<std::vector<fs::path>> find_pictures(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> paths;
  for (fs::directory_iterator it(folder, failure), end; !failure && it != end; it.increment(failure))
    if (base::to_lower(it->path().extension().string()) == ".png") paths.push_back(it->path());
  if (failure) return base::Error{base::ErrorCode::kNotFound, "--textures: no such folder", folder.string()};
  std::sort(paths.begin(), paths.end());
  return paths;
}

// Makes a WAD whose textures are named like the files.
base::Result<base::ByteVector> make_picture_wad(const std::vector<fs::path>& pictures,
                                                const formats::Palette& palette) {
  std::vector<base::ByteVector> bytes;
  for (const fs::path& path : pictures) {
    TRY(base::ByteVector png, vfs::read_disk_file(path));
    bytes.push_back(std::move(png));
  }
  std::vector<compiler::PngFile> files;
  for (std::size_t i = 0; i < pictures.size(); ++i) files.push_back({pictures[i].string(), bytes[i]});
  return compiler::make_wad(files, palette);
}

// Adds the first candidate that can be read. Stamps all that were tried, so that a file that appears later
// counts as a change.
bool add_first_readable(const std::vector<fs::path>& candidates, std::vector<FileStamp>& io_stamps,
                        TextureFiles& io_files) {
  for (const fs::path& path : candidates) {
    io_stamps.push_back(read_file_stamp(path));
    base::Result<base::ByteVector> file = vfs::read_disk_file(path);
    if (!file.ok()) continue;
    io_files.add(path.filename().string(), std::move(file).value());
    return true;
  }
  return false;
}

// Lists the textures of all sides, with repetitions.
std::vector<std::string_view> find_names(const formats::Map& map) {
  std::vector<std::string_view> names;
  for (const formats::MapEntity& entity : map.entities)
    for (const formats::MapBrush& brush : entity.brushes)
      for (const formats::MapSide& side : brush.sides)
        if (names.empty() || names.back() != side.texture) names.emplace_back(side.texture);
  return names;
}

}  // namespace

void TextureFiles::add(std::string name, base::ByteVector file) {
  bytes.push_back(std::make_unique<base::ByteVector>(std::move(file)));
  sources.push_back({std::move(name), *bytes.back()});
}

base::Result<base::ByteVector> make_wad_from_pictures(const fs::path& folder,
                                                      const formats::Palette& palette) {
  TRY(const std::vector<fs::path> pictures, find_pictures(folder));
  if (pictures.empty())
    return base::Error{base::ErrorCode::kNotFound, "--textures: the folder has no .png file",
                       folder.string()};
  return make_picture_wad(pictures, palette);
}

base::Result<base::ByteVector> make_builtin_wad(std::span<const std::string_view> names) {
  std::vector<formats::BspMiptex> textures = artgen::make_small_level_textures(names);
  std::vector<base::ByteVector> records;
  records.reserve(textures.size());
  std::vector<formats::WadLump> lumps;
  for (formats::BspMiptex& texture : textures) {
    TRY(base::ByteVector record,
        formats::write_wad_texture({texture.name, texture.width, texture.height, std::move(texture.mips)}));
    records.push_back(std::move(record));
    lumps.push_back({std::move(texture.name), formats::kWadTexture, records.back()});
  }
  return formats::write_wad(lumps);
}

std::vector<fs::path> list_game_wads(const GameFolders& folders) {
  constexpr const char* kFile = "textures.wad";
  const base::Result<fs::path> base_folder = find_base_folder(folders);
  std::vector<fs::path> wads;
  if (!base_folder.ok()) return wads;
  for (auto game = folders.games.rbegin(); game != folders.games.rend(); ++game)
    wads.push_back(*base_folder / *game / kFile);
  wads.push_back(*base_folder / "id1" / kFile);
  return wads;
}

// Returns whether a WAD with the entry's file name is already used, from --wad or a game directory. Editors
// write absolute paths of the mapper's machine into the "wad" key, which do not exist elsewhere.
bool is_already_included(const std::string& entry, const TexturePlaces& places) {
  const auto is_named = [&](const fs::path& wad) {
    const std::vector<fs::path> beside = compiler::wad_candidates(entry, wad.parent_path(), {});
    std::error_code ignored;
    return fs::is_regular_file(wad, ignored) &&
           std::ranges::find(beside, wad.lexically_normal()) != beside.end();
  };
  return std::ranges::any_of(places.wads, is_named) || std::ranges::any_of(places.game_wads, is_named);
}

// Adds the sources in the order that the header gives. Everything that was searched is stamped before it is
// read.
base::Result<TextureFiles> find_textures(const TexturePlaces& places, const fs::path& map_path,
                                         const formats::Map& map, const formats::Palette& palette,
                                         std::vector<FileStamp>& io_stamps, compiler::Warnings& io_warnings) {
  TextureFiles files;
  if (!places.pictures.empty()) {
    io_stamps.push_back(read_file_stamp(places.pictures));
    TRY(const std::vector<fs::path> pictures, find_pictures(places.pictures));
    for (const fs::path& picture : pictures) io_stamps.push_back(read_file_stamp(picture));
    TRY(base::ByteVector wad, make_picture_wad(pictures, palette));
    files.add(places.pictures, std::move(wad));
  }
  std::vector<fs::path> folders;
  std::vector<std::string> wads;
  for (const std::string& wad : places.wads) {
    std::error_code ignored;
    if (fs::is_directory(wad, ignored))
      folders.emplace_back(wad);
    else
      wads.push_back(wad);
  }
  for (const std::string& wad : std::views::reverse(wads)) {
    io_stamps.push_back(read_file_stamp(wad));
    base::Result<base::ByteVector> file = vfs::read_disk_file(wad);
    if (!file.ok()) {
      const base::Error& why = file.error();
      return base::Error{why.code, "--wad: " + why.what, wad};
    }
    files.add(fs::path(wad).filename().string(), std::move(file).value());
  }
  const std::string_view key =
      map.entities.empty() ? "" : map.entities.front().fields.find("wad").value_or("");
  const std::vector<std::string> entries = compiler::split_wad_key(key);
  for (const std::string& entry : std::views::reverse(entries)) {
    // Quoted texts are usually cut off sooner, but paths are long.
    constexpr std::size_t kMaxChars = 120;
    const bool is_found = add_first_readable(compiler::wad_candidates(entry, map_path.parent_path(), folders),
                                             io_stamps, files);
    if (!is_found && !is_already_included(entry, places))
      io_warnings.push_back(
          {"WAD not found",
           fmt::format(
               "{} in the \"wad\" key of worldspawn, line {} (use {} FOLDER to add a folder to search)",
               base::quotable(entry, kMaxChars), map.entities.front().line, places.wad_option)});
  }
  // The built-in textures use Temblor's palette, so they would have wrong colors with another one.
  if (palette == artgen::make_palette()) {
    TRY(base::ByteVector builtin, make_builtin_wad(find_names(map)));
    files.add("Temblor's own", std::move(builtin));
  }
  for (const fs::path& wad : places.game_wads) add_first_readable({wad}, io_stamps, files);
  return files;
}

}  // namespace temblor::app
