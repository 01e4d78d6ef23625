#include "support/levels/drawable_level.h"

#include <map>
#include <tuple>
#include <type_traits>

#include "artgen/palette.h"
#include "assets/assets.h"

namespace temblor::test {

DrawableLevel stock_level(const std::filesystem::path& base_folder, const std::string& map_name) {
  const vfs::FileSystem files = vfs::FileSystem::open(base_folder).value();
  const assets::Look look = assets::load_look(files).value();
  return {map_name, assets::load_level(files, map_name).value().level, look.palette, look.colormap};
}

DrawableLevel small_level(const artgen::SmallLevelOptions& options, const std::string& name) {
  const auto [pvs, light, four_styles, wide_faces, edge_used_three_times, missing_texture, colored_light,
              tiny, seed] = options;
  const auto key = std::tuple(pvs, light, four_styles, wide_faces, edge_used_three_times, missing_texture,
                              colored_light, tiny, seed, name);
  static std::map<std::remove_const_t<decltype(key)>, DrawableLevel> made;
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  const formats::Palette palette = artgen::make_palette();
  auto level = world::make_level(artgen::make_small_level(options), name).value();
  return made.emplace(key, DrawableLevel{name, level, palette, formats::make_colormap(palette)})
      .first->second;
}

std::vector<SmallLevelVariant> small_level_variants() {
  using Options = artgen::SmallLevelOptions;
  std::vector<SmallLevelVariant> variants = {{"plain", {}}};
  const auto add = [&](const char* name, auto set) {
    set(variants.emplace_back(SmallLevelVariant{name, {}}).options);
  };
  add("without_pvs", [](Options& options) { options.pvs = false; });
  add("without_light", [](Options& options) { options.light = false; });
  add("four_styles", [](Options& options) { options.four_styles = true; });
  add("wide_faces", [](Options& options) { options.wide_faces = true; });
  add("edge_used_three_times", [](Options& options) { options.edge_used_three_times = true; });
  add("missing_texture", [](Options& options) { options.missing_texture = true; });
  add("colored_light", [](Options& options) { options.colored_light = true; });
  add("tiny", [](Options& options) { options.tiny = true; });
  add("all", [](Options& options) {
    options.four_styles = options.wide_faces = options.edge_used_three_times = true;
    options.missing_texture = options.colored_light = true;
  });
  return variants;
}

}  // namespace temblor::test
