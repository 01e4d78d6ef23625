#include "app/compile/change_map.h"

#include <algorithm>
#include <string_view>

#include "compiler/world_keys.h"

namespace temblor::app {
namespace {

struct DetailClass {
  std::string_view classname;
  std::uint8_t kind;
  // Fences and illusionary brushes stay detail: as structure, they would block the view.
  bool can_be_structure;
};
constexpr DetailClass kDetailClasses[] = {
    {"func_detail", kPlainDetail, true},
    {"func_detail_wall", kWallDetail, true},
    {"func_detail_fence", kFenceDetail, false},
    {"func_detail_illusionary", kIllusionaryDetail, false},
};

void become_group(formats::Entity& io_fields) {
  for (auto& [key, value] : io_fields.pairs)
    if (key == "classname") value = "func_group";
}

}  // namespace

void change_map(const CompileCommandOptions& options, formats::Map& io_map) {
  if (!io_map.entities.empty()) compiler::set_keys(options.world_keys, io_map.entities.front().fields);
  for (formats::MapEntity& entity : io_map.entities) {
    const auto found = std::ranges::find(kDetailClasses, entity.fields.classname(), &DetailClass::classname);
    if (found == std::end(kDetailClasses)) continue;
    if ((options.omitted_detail & found->kind) != 0) {
      become_group(entity.fields);
      entity.brushes.clear();
    } else if (options.no_detail && found->can_be_structure) {
      become_group(entity.fields);
    }
  }
}

}  // namespace temblor::app
