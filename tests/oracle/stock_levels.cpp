#include "oracle/stock_levels.h"

namespace temblor::oracle {

JudgedLevel load_judged_level(const std::filesystem::path& base_folder, const std::string& map_name) {
  const vfs::FileSystem files = vfs::FileSystem::open(base_folder).value();
  auto level = assets::load_level(files, map_name).value().level;
  return {level, assets::load_look(files).value(), PreparedLevel(*level)};
}

}  // namespace temblor::oracle
