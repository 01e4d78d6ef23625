// Finds the files with a map's textures. Sources are searched in this order, and the first with a name wins:
//
//   1. --textures: a folder of PNG files
//   2. --wad: WADs and levels, the last one first, as in ericw-tools; and folders of WADs
//   3. the WADs that the map's "wad" key names, the last one first
//   4. with Temblor's own palette, the textures of the small built-in level
//   5. textures.wad of the game directories, the last one first
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/options.h"
#include "app/files/file_watch.h"
#include "base/bytes.h"
#include "base/result.h"
#include "compiler/report.h"
#include "compiler/texture_set.h"
#include "formats/images/palette.h"
#include "formats/levels/map.h"

namespace temblor::app {

// Texture sources and the bytes that they point into. The bytes are allocated one by one, so they stay where
// they are when the structure is moved or grows.
struct TextureFiles {
  std::vector<std::unique_ptr<base::ByteVector>> bytes;
  std::vector<compiler::TextureSource> sources;

  void add(std::string name, base::ByteVector file);
};

struct TexturePlaces {
  // Folder of PNG files; empty: none.
  std::string pictures;
  // WADs, levels, and folders to search for the map's WADs.
  std::vector<std::string> wads;
  // WADs of the game directories; missing ones are skipped.
  std::vector<std::filesystem::path> game_wads{};
  // The option that adds to `wads`, for messages.
  std::string wad_option = "--wad";
};

// Converts the PNG files of a folder to a WAD. kNotFound if there is none.
base::Result<base::ByteVector> make_wad_from_pictures(const std::filesystem::path& folder,
                                                      const formats::Palette& palette);

// Makes a WAD of the small built-in level's textures with these names, and their animations. It is empty if
// the level has none of them.
base::Result<base::ByteVector> make_builtin_wad(std::span<const std::string_view> names);

// Lists the paths GAME/textures.wad of the game directories, the last one first. The files need not exist.
// Empty without game data.
std::vector<std::filesystem::path> list_game_wads(const GameFolders& folders);

// Reads all texture sources, in order of priority. A WAD that only the map names and that does not exist is a
// warning; one that the command line names is an error. `io_stamps` receives a stamp of every file that was
// read or searched, taken before reading, also on failure.
base::Result<TextureFiles> find_textures(const TexturePlaces& places, const std::filesystem::path& map_path,
                                         const formats::Map& map, const formats::Palette& palette,
                                         std::vector<FileStamp>& io_stamps, compiler::Warnings& io_warnings);

}  // namespace temblor::app
