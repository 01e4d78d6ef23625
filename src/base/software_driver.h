// Drivers of OpenGL that draw on the CPU.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace temblor::base {

// `name`: GL_RENDERER. Only the name tells.
inline bool is_software_driver(std::string_view name) {
  constexpr std::array<std::string_view, 4> kSoftware = {"llvmpipe", "softpipe", "swrast", "SwiftShader"};
  return std::ranges::any_of(kSoftware, [&](std::string_view each) { return name.find(each) != name.npos; });
}

}  // namespace temblor::base
