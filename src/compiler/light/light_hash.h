// Tells whether two processes light the same level by the same lights.
#pragma once

#include <cstdint>

#include "compiler/light_level.h"

namespace temblor::compiler {

// The level that light falls on: as it is, but for light and what follows from it.
formats::Bsp unlit(const formats::Bsp& bsp);

std::uint64_t hash_of_light_input(const formats::Bsp& unlit, const FaceKeys& face_keys,
                                  const LightOptions& options);

}  // namespace temblor::compiler
