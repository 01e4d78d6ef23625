// What the brushes of an entity become, by its classname.
#pragma once

#include <array>
#include <string_view>

#include "compiler/bsp/brush.h"

namespace temblor::compiler {

struct BrushClass {
  std::string_view classname;
  Fill solid;  // of its brushes that are not liquid or sky
  bool is_detail;
};

// Their brushes are the world's.
constexpr std::array<BrushClass, 6> kWorldClasses = {{
    {"worldspawn", Fill::kSolid, false},
    {"func_group", Fill::kSolid, false},
    {"func_detail", Fill::kDetail, true},
    {"func_detail_wall", Fill::kDetail, true},
    {"func_detail_fence", Fill::kFence, true},
    {"func_detail_illusionary", Fill::kIllusionary, true},
}};
constexpr BrushClass kModelClass = {"", Fill::kSolid, false};

// Null: an entity of its own.
inline const BrushClass* world_class(std::string_view classname) {
  for (const BrushClass& known : kWorldClasses)
    if (known.classname == classname) return &known;
  return nullptr;
}

}  // namespace temblor::compiler
