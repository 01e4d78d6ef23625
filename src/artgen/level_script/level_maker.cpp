#include "artgen/level_script/level_maker.h"

#include <fmt/format.h>

#include <cstring>
#include <string>
#include <utility>

#include "artgen/level_script/level_script_map.h"
#include "formats/levels/map.h"

namespace temblor::artgen {

base::Result<std::vector<ArtPart>> make_level(const ScriptLine& level) {
  TRY(const LevelScript script, read_level_script(level));
  TRY_STATUS(check_level_script(script));
  const std::string text = formats::write_map(make_map(script));
  base::ByteVector bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  std::vector<ArtPart> parts;
  parts.push_back({fmt::format("maps/{}.map", script.name), std::move(bytes)});
  return parts;
}

}  // namespace temblor::artgen
