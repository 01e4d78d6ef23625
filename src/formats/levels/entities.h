// The entity text of a level: one block for each entity, with the fields that the mapper has set. The first
// one is worldspawn.
//
//   {
//   "classname" "light"
//   "origin" "128 -64 40"
//   "light" "300"
//   }
//
// Keys are the names of QuakeC fields; the server converts the values to the types of the fields.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// An entity as text.
struct Entity {
  std::vector<std::pair<std::string, std::string>> pairs;  // key and value, in file order; keys may repeat

  // Returns the value of the first pair with this key, or nullopt.
  std::optional<std::string_view> find(std::string_view key) const;
  std::string_view classname() const { return find("classname").value_or(""); }
  // Parses "x y z". Returns nullopt if the key is missing or the value is not exactly three finite numbers.
  std::optional<math::Vec3> find_vec3(std::string_view key) const;
  // Returns nullopt if the key is missing or the value is not exactly one finite number.
  std::optional<float> find_number(std::string_view key) const;

  bool operator==(const Entity&) const = default;
};

// Entities, and the first fault of their text with its line; empty: none.
struct EntityText {
  std::vector<Entity> entities;
  std::string first_fault;
};

// Parses entity text. Keys and values are quoted, and may contain anything except quotes (backslashes are not
// escapes); or they are bare words up to white space or a brace. Comments run from // to the end of
// the line, or from /* to */. The text ends at its first zero byte.
//
// Passes over faults, so that a level with a damaged entity can be played: an entity also ends at the next
// opening brace and at the end of the text, a quote also ends at the end of the text, a key without a value
// is left out, and so is text outside of entities.
EntityText read_faulty_entities(std::string_view text);

// The same, but a fault is an error, for programs that write the text again.
base::Result<std::vector<Entity>> read_entities(std::string_view text);

// Writes entity text. Entities that were read, and others without a quote or zero byte in a key or value,
// read back equal.
std::string write_entities(const std::vector<Entity>& entities);

}  // namespace temblor::formats
