// The reports of a compilation to the mapper: its progress, the problems that it could work around, and
// where the level leaks. The compiler itself prints nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/function_ref.h"
#include "math/vec.h"

namespace temblor::compiler {

// Called with the number of finished steps of a stage, by one thread at a time. Returns false to stop the
// stage.
using Progress = base::FunctionRef<bool(std::size_t done, std::size_t total)>;

// Never stops.
inline constexpr auto kIgnoreProgress = [](std::size_t, std::size_t) { return true; };

// Something that the mapper should fix, though the level works without.
struct Warning {
  std::string kind;  // what is wrong; warnings of one kind are printed together: "texture not found"
  std::string what;  // where it is (entity, brush, line), and what to do about it
};

using Warnings = std::vector<Warning>;

// Follows a compilation. This base class ignores everything.
class CompileWatcher {
 public:
  virtual ~CompileWatcher() = default;
  // `name` lives as long as the program.
  virtual void begin_stage(const char* /*name*/) {}
  // The progress of the stage that began last; called by one thread at a time. Returns false to stop.
  virtual bool progress(std::size_t /*done*/, std::size_t /*total*/) { return true; }
  // Called every few minutes while visibility is computed, with the new Build::visibility_state.
  virtual void save(base::Bytes /*visibility_state*/) {}
};

// The path along which a level that is not sealed leaks: from an entity through open space to the void
// outside.
struct LeakPath {
  std::size_t entity;                     // its number in the map, from 0
  std::uint32_t line;                     // of the entity, in the map's text
  std::string classname;                  // of the entity, shortened and escaped for messages
  std::vector<math::Vec3d> points_world;  // the entity's origin first, the outside last
};

}  // namespace temblor::compiler
