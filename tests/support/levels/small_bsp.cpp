#include "support/levels/small_bsp.h"

#include <map>
#include <tuple>
#include <type_traits>

namespace temblor::test {

const formats::Bsp& small_bsp(const artgen::SmallLevelOptions& options) {
  const auto [pvs, light, four_styles, wide_faces, edge_used_three_times, missing_texture, colored_light,
              tiny, seed] = options;
  const auto key = std::tuple(pvs, light, four_styles, wide_faces, edge_used_three_times, missing_texture,
                              colored_light, tiny, seed);
  static std::map<std::remove_const_t<decltype(key)>, formats::Bsp> made;
  const auto found = made.find(key);
  return found != made.end() ? found->second
                             : made.emplace(key, artgen::make_small_level(options)).first->second;
}

}  // namespace temblor::test
