// Tells whether two processes light the same level by the same lights.
#pragma once

#include <cstdint>

#include "compiler/light_level.h"

namespace temblor::compiler {

// `unlit`: light and what follows from it thrown away.
std::uint64_t hash_of_light_input(const formats::Bsp& unlit, const FaceKeys& face_keys,
                                  const LightOptions& options);

}  // namespace temblor::compiler
