// Maps of the data, compiled with the textures that they name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile_level.h"
#include "formats/images/palette.h"
#include "formats/levels/map.h"

namespace temblor::test {

// Every map of the data's `mapsrc` that has a finished level of its name; those named b_* are boxes of
// supplies, seen from outside. Sanitizer builds get the quickest of either kind.
std::vector<const char*> stock_maps();

// CHECKs that the data has it.
formats::Map stock_map(const std::filesystem::path& base_folder, const std::string& name);

struct StockTextures {
  formats::Palette palette;
  std::vector<base::ByteVector> bytes;
  std::vector<compiler::TextureSource> sources;  // into `bytes`
};
// The WADs that the map names, in its order, and the game's palette.
StockTextures stock_textures(const std::filesystem::path& base_folder, const formats::Map& map);

struct CompiledMap {
  compiler::Build level;
  std::optional<compiler::LeakPath> leak;
  compiler::Warnings warnings;
};
// CHECKs that it compiles.
CompiledMap compile_stock_map(const std::filesystem::path& base_folder, const std::string& name,
                              const compiler::CompileOptions& options, int threads = 2);

}  // namespace temblor::test
