#include "artgen/level_script/level_maker.h"

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <utility>

#include "artgen/level_script/plan_map.h"
#include "formats/levels/map.h"

namespace temblor::artgen {

base::Result<std::vector<ArtPart>> make_level(const ScriptLine& level) {
  TRY(const Plan plan, read_plan(level));
  TRY_STATUS(check_plan(plan));
  const std::string text = formats::write_map(map_of_plan(plan));
  base::ByteVector bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  std::vector<ArtPart> parts;
  parts.push_back({fmt::format("maps/{}.map", plan.name), std::move(bytes)});
  return parts;
}

}  // namespace temblor::artgen
