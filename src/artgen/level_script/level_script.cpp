#include "artgen/level_script/level_script.h"

namespace temblor::artgen {

Looks make_looks(const Surfaces& surfaces, const Box& anchor) {
  Looks looks;
  for (const Side side : kSides) looks[side_index(side)] = {surfaces[side_index(side)], anchor};
  return looks;
}

Looks make_uniform_looks(std::string_view texture, const Box& anchor) {
  return make_looks(make_uniform_surfaces(texture), anchor);
}

Surfaces make_uniform_surfaces(std::string_view texture) {
  Surfaces surfaces;
  surfaces.fill(std::string(texture));
  return surfaces;
}

}  // namespace temblor::artgen
