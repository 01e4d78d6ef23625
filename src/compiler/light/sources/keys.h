// Reads the keys of the light stage. Each works with and without a leading underscore.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::compiler {

// `key` is without underscore. Returns nothing, or `otherwise`, if its value is not a number.
std::optional<float> read_number(const formats::Entity& entity, std::string_view key);
float read_number_or(const formats::Entity& entity, std::string_view key, float otherwise);

// Returns 1 for a number above 0, 0 for others, and -1 without a number.
std::int8_t read_flag(const formats::Entity& entity, std::string_view key);

// Reads a color in 0 to 1, or, if any channel is above 1, in 0 to 255. Returns it in 0 to 1.
std::optional<math::Vec3> read_color(const formats::Entity& entity, std::string_view key);

// Reads a mask of light channels: a number from 0 to 2^24 - 1. Returns nothing for other values.
std::optional<std::uint32_t> read_channels(const formats::Entity& entity, std::string_view key);

// Reads three numbers; nothing for other values.
std::optional<math::Vec3> read_vec3(const formats::Entity& entity, std::string_view key);

// Reads a direction as "yaw pitch roll". Positive pitch looks up here, unlike in the angles of entities.
std::optional<math::Vec3> read_mangle(const formats::Entity& entity, std::string_view key);

}  // namespace temblor::compiler
