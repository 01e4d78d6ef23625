#include "server/game/server_models.h"

#include <fmt/format.h>

#include "assets/posed_models.h"
#include "formats/levels/bsp.h"

namespace temblor::server {

std::vector<ServerModel> make_level_models(const world::Level& level, std::string_view path) {
  std::vector<ServerModel> models(1);
  for (std::size_t i = 0; i < level.models.size(); ++i) {
    const auto index = base::to_index<world::ModelIndex>(i);
    models.push_back({i == 0 ? std::string(path) : fmt::format("*{}", i), level.models[i].bounds, index});
  }
  return models;
}

// MDL files and sprites are not read: their size does not matter here, and dedicated servers load faster.
// The box of a .bsp is one unit larger on each side, as the original has it for all brush models.
base::Result<ServerModel> load_server_model(const assets::Library& library, std::string_view name) {
  if (name.ends_with(".bsp")) {
    TRY(const base::ByteVector bytes, library.files().read(name));
    TRY(const formats::Bsp bsp, formats::read_bsp(bytes).with_file(library.files().describe(name)));
    const formats::BspModel& model = bsp.models.at(0);
    return ServerModel{std::string(name), {model.mins - 1.0f, model.maxs + 1.0f}};
  }
  if (assets::is_posed_model(name)) {
    TRY(const math::Bounds bounds, assets::measure_posed_model(library.files(), name));
    return ServerModel{std::string(name), bounds};
  }
  if (!library.files().contains(name)) {
    base::Error error = base::error(base::ErrorCode::kNotFound, "there is no such model");
    error.file = name;
    return error;
  }
  return ServerModel{std::string(name), {math::Vec3{-16.0f}, math::Vec3{16.0f}}};
}

}  // namespace temblor::server
