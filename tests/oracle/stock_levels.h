// The levels of stock data that pictures are held against the oracle on.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "assets/assets.h"
#include "oracle/ray_scene.h"
#include "world/level.h"

namespace temblor::oracle {

// A level with all that is needed to draw and to judge it.
struct JudgedLevel {
  std::shared_ptr<const world::Level> level;
  assets::Look look;
  PreparedLevel prepared;
};

// CHECKs that the data has it.
JudgedLevel load_judged_level(const std::filesystem::path& base_folder, const std::string& map_name);

}  // namespace temblor::oracle
