#include "compiler/light/sources/keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace temblor::compiler {
namespace {

std::string add_underscore(std::string_view key) {
  return fmt::format("_{}", key);
}

}  // namespace

// If both spellings are there, the one with an underscore counts.
std::optional<float> read_number(const formats::Entity& entity, std::string_view key) {
  if (const auto value = entity.find_number(add_underscore(key))) return value;
  return entity.find_number(key);
}

float read_number_or(const formats::Entity& entity, std::string_view key, float otherwise) {
  return read_number(entity, key).value_or(otherwise);
}

std::optional<std::uint32_t> read_channels(const formats::Entity& entity, std::string_view key) {
  constexpr float kEnd = 1 << 24;
  const std::optional<float> mask = read_number(entity, key);
  if (!mask || *mask < 0 || *mask >= kEnd) return std::nullopt;
  return static_cast<std::uint32_t>(*mask);
}

std::optional<math::Vec3> read_vec3(const formats::Entity& entity, std::string_view key) {
  if (const auto value = entity.find_vec3(add_underscore(key))) return value;
  return entity.find_vec3(key);
}

std::int8_t read_flag(const formats::Entity& entity, std::string_view key) {
  const std::optional<float> number = read_number(entity, key);
  return number ? std::int8_t{*number > 0} : std::int8_t{-1};
}

std::optional<math::Vec3> read_color(const formats::Entity& entity, std::string_view key) {
  const std::optional<math::Vec3> color = read_vec3(entity, key);
  if (!color) return std::nullopt;
  const math::Vec3 positive = glm::max(*color, math::Vec3(0.0f));
  const bool in_bytes = std::max({positive.x, positive.y, positive.z}) > 1;
  return in_bytes ? positive / 255.0f : positive;
}

// The length is 1. Roll does not change a direction.
std::optional<math::Vec3> read_mangle(const formats::Entity& entity, std::string_view key) {
  const std::optional<math::Vec3> mangle = read_vec3(entity, key);
  if (!mangle) return std::nullopt;
  constexpr double kRadians = std::numbers::pi / 180;
  const double yaw = double{mangle->x} * kRadians, pitch = double{mangle->y} * kRadians;
  return math::Vec3(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch), std::sin(pitch));
}

}  // namespace temblor::compiler
