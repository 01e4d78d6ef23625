#include "compiler/compiled_maps.h"

#include "assets/assets.h"
#include "base/bytes.h"
#include "compiler/wad_paths.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "vfs/file_system.h"

namespace temblor::test {
namespace fs = std::filesystem;

std::vector<const char*> stock_maps() {
  if (kQuick) return {"lq_e0m9", "b_bh25"};
  return {"start",  "lq_e0m1", "lq_e0m3", "lq_e0m9",  "lq_e1m2", "lqdm5",
          "lqdm11", "lqdm12",  "b_bh25",  "b_explob", "b_rock0"};
}

std::vector<const char*> stock_maps_for_hulls() {
  if (kQuick) return {"start", "lqdm11"};
  return {"start", "lq_e0m1", "lq_e0m3", "lqdm5", "lqdm11"};
}

formats::Map read_stock_map(const fs::path& base_folder, const std::string& name) {
  const base::ByteVector text = read_file(base_folder / "mapsrc" / (name + ".map"));
  return formats::read_map(base::as_text(text)).value();
}

StockTextures read_stock_textures(const fs::path& base_folder, const formats::Map& map) {
  StockTextures textures;
  const vfs::FileSystem files = vfs::FileSystem::open(base_folder).value();
  textures.palette = assets::load_look(files).value().palette;
  const std::string_view key = map.entities.front().fields.find("wad").value_or("");
  std::vector<fs::path> paths;
  for (const std::string& entry : compiler::split_wad_key(key))
    paths.push_back(base_folder / "wads" / fs::path(entry).filename());
  for (const fs::path& path : paths) textures.bytes.push_back(read_file(path));
  for (std::size_t i = 0; i < paths.size(); ++i)
    textures.sources.push_back({paths[i].filename().string(), textures.bytes[i]});
  return textures;
}

CompiledMap compile_stock_map(const fs::path& base_folder, const std::string& name,
                              const compiler::CompileOptions& options, int threads) {
  const formats::Map map = read_stock_map(base_folder, name);
  const StockTextures textures = read_stock_textures(base_folder, map);
  base::Jobs jobs(threads);
  compiler::CompileWatcher nobody;
  compiler::Warnings warnings;
  compiler::Build level;
  compiler::CompileReport report = compiler::compile_level({map, textures.sources, textures.palette}, options,
                                                           {jobs, nobody, warnings}, level)
                                       .value();
  return {std::move(level), std::move(report.leak), std::move(warnings)};
}

}  // namespace temblor::test
