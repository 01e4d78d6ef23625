// The files that a map's textures come from: those that the command line names, then those that the map does.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
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

// What `sources` point to lives as long as this does.
struct TextureFiles {
  std::vector<std::unique_ptr<base::ByteVector>> bytes;
  std::vector<compiler::TextureSource> sources;

  void add(std::string name, base::ByteVector file);
};

struct TexturePlaces {
  std::string pictures;           // a folder of PNG files; empty: none
  std::vector<std::string> wads;  // WADs, levels, and folders in which the map's WADs may lie
  std::vector<std::filesystem::path>
      game_wads{};  // of the game folders; those that are not there are passed over
};

// A WAD of the PNG files of a folder.
base::Result<base::ByteVector> wad_of_pictures(const std::filesystem::path& folder,
                                               const formats::Palette& palette);

// Where game folders may have a WAD of textures, as the shipped game has: that of the last folder first.
// Empty: there is no game.
std::vector<std::filesystem::path> wads_of_games(const GameFolders& folders);

// In the order in which textures are looked for: pictures, `wads`, what the map's "wad" key names; with
// the project's own palette the textures of the level made in code (artgen/small_level.h); `game_wads`. What
// the map names and nobody has is a warning; what the command line names must be there. `io_stamps`: gets
// those of all that is read, or looked for in vain, as it was before; also when this fails.
base::Result<TextureFiles> find_textures(const TexturePlaces& places, const std::filesystem::path& map_path,
                                         const formats::Map& map, const formats::Palette& palette,
                                         std::vector<FileStamp>& io_stamps, compiler::Warnings& io_warnings);

}  // namespace temblor::app
