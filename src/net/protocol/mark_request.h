// A game's request to show a mark: a picture, or one of the shapes that shots leave. It is a console comment
// in svc_stufftext, which stock clients ignore, so game code can send it with the stock functions
// (docs/modding.md):
//
//   //temblor mark PICTURE X Y Z RADIUS [TURN [*N]]
//
// X Y Z may be in single quotes, as vtos() writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::net {

struct MarkRequest {
  static constexpr float kMinRadius = 0.5f, kMaxRadius = 128;  // units
  static constexpr std::size_t kMaxNameChars = 32;

  // 1 to kMaxNameChars letters, digits, "_", and "-", in lower case: gfx/marks/PICTURE.png. Or "*hole",
  // "*scorch", or "*blood".
  std::string picture;
  // Near the surface; in the space of `model` if that is set.
  math::Vec3 origin{0.0f};
  float radius = 0;    // units; half the longer side of a picture
  float turn_deg = 0;  // clockwise
  // The brush model *N of the level that carries the mark, from 1.
  std::optional<std::uint32_t> model{};
  bool operator==(const MarkRequest&) const = default;
};

// Whether a line of stuffed text, without its line end, is meant as a request.
bool is_mark_request(std::string_view line);
// Parses such a line. Errors say which part is wrong.
base::Result<MarkRequest> read_mark_request(std::string_view line);

}  // namespace temblor::net
