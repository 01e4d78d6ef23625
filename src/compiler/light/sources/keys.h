// Reading the keys that mappers give the light compiler: each is known with and without its underscore.
#pragma once

#include <optional>
#include <string_view>

#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::compiler {

// `key` without underscore. Nothing when it is no number.
std::optional<float> number_of(const formats::Entity& entity, std::string_view key);
float number_or(const formats::Entity& entity, std::string_view key, float otherwise);

// A color in 0 to 1, or in 0 to 255 as soon as one channel is above 1; returned in 0 to 1.
std::optional<math::Vec3> color_of(const formats::Entity& entity, std::string_view key);

// The way that "yaw pitch roll" points: pitch up is positive here, unlike that of entities' angles.
std::optional<math::Vec3> direction_of_mangle(const formats::Entity& entity, std::string_view key);

}  // namespace temblor::compiler
