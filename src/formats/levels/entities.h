// The entity text of a level: { "key" "value" ... } blocks.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

struct Entity {
  std::vector<std::pair<std::string, std::string>> pairs;  // in file order

  // The value of the first pair of that key, or nothing.
  std::optional<std::string_view> find(std::string_view key) const;
  std::string_view classname() const { return find("classname").value_or(""); }
  // "x y z"; nothing when missing or not exactly three finite numbers.
  std::optional<math::Vec3> find_vec3(std::string_view key) const;
  // Nothing when missing or not exactly one finite number.
  std::optional<float> find_number(std::string_view key) const;

  bool operator==(const Entity&) const = default;
};

// Keys and values are quoted, with anything but a quote between the quotes, taken as it lies (backslashes are
// not escapes here); or bare words, up to white space, a brace or a quote. Comments run from // to the end of
// the line. The text ends at its first zero byte. Errors name the line.
base::Result<std::vector<Entity>> read_entities(std::string_view text);

// Keys and values must hold neither a quote nor a zero byte; then the text reads back as the same entities.
std::string write_entities(const std::vector<Entity>& entities);

}  // namespace temblor::formats
