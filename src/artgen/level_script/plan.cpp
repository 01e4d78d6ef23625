#include "artgen/level_script/plan.h"

namespace temblor::artgen {

Looks looks_of(const Surfaces& surfaces, const Box& anchor) {
  Looks looks;
  for (const Side side : kSides) looks[index_of(side)] = {surfaces[index_of(side)], anchor};
  return looks;
}

Looks looks_all(std::string_view texture, const Box& anchor) {
  return looks_of(surfaces_all(texture), anchor);
}

Surfaces surfaces_all(std::string_view texture) {
  Surfaces surfaces;
  surfaces.fill(std::string(texture));
  return surfaces;
}

}  // namespace temblor::artgen
