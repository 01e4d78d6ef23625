// Maps of the game data, compiled with the textures that they name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile_level.h"
#include "formats/images/palette.h"
#include "formats/levels/map.h"

namespace temblor::test {

// Every map in the data's `mapsrc` with a finished level of its name. Those named b_* are item boxes, seen
// from outside. Sanitizer builds get the quickest of both kinds.
std::vector<const char*> stock_maps();

// Some of these, for tests that compare their hulls with brushes. Sanitizer builds get the two smallest ones,
// because they take most of a minute to compile the others.
std::vector<const char*> stock_maps_for_hulls();

// CHECKs that the data has the map.
formats::Map read_stock_map(const std::filesystem::path& base_folder, const std::string& name);

struct StockTextures {
  formats::Palette palette;
  std::vector<base::ByteVector> bytes;
  std::vector<compiler::TextureSource> sources;  // views of `bytes`
};
// Reads the WADs that the map names, in its order, and the game's palette.
StockTextures read_stock_textures(const std::filesystem::path& base_folder, const formats::Map& map);

struct CompiledMap {
  compiler::Build level;
  std::optional<compiler::LeakPath> leak;
  compiler::Warnings warnings;
};
// CHECKs that it compiles.
CompiledMap compile_stock_map(const std::filesystem::path& base_folder, const std::string& name,
                              const compiler::CompileOptions& options, int threads = 2);

}  // namespace temblor::test
