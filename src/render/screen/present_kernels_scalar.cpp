#include "render/screen/present_kernels.h"

namespace temblor::render {

void expand_palette_scalar(const std::uint8_t* indices, std::size_t count, const std::uint32_t* colors,
                           std::uint32_t* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = colors[indices[i]];
}

}  // namespace temblor::render
