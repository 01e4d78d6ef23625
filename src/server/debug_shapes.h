// Lines and texts that game code draws into the level for its developers (ex_draw_line() and others). They
// are kept for the player at this computer, and never sent or saved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "math/vec.h"

namespace temblor::server {

struct DebugLine {
  math::Vec3 from_world{0.0f}, to_world{0.0f};
  std::uint8_t color = 0;  // palette index
};

// A text that faces the viewer, with the middle of its letters at `origin_world`.
struct DebugText {
  std::string text;
  math::Vec3 origin_world{0.0f};
  float size = 8;  // units, from the bottom to the top of a letter
};

// How long a shape is shown, and whether walls and models hide it.
struct DebugLook {
  double end_time_s = 0;
  bool is_depth_tested = false;
};

// QuakeC may have written any numbers into shapes.
class DebugShapes {
 public:
  // More than these are ignored.
  static constexpr std::size_t kMaxLines = 16384, kMaxTexts = 256, kMaxTextChars = 128;

  template <typename Shape>
  struct Shown {
    Shape shape;
    DebugLook look;
  };

  void add(const DebugLine& line, const DebugLook& look);
  // Keeps the first kMaxTextChars of the text.
  void add(DebugText text, const DebugLook& look);
  // Forgets the shapes that end before this time.
  void drop_ended(double time_s);

  std::span<const Shown<DebugLine>> lines() const { return lines_; }
  std::span<const Shown<DebugText>> texts() const { return texts_; }

 private:
  std::vector<Shown<DebugLine>> lines_;
  std::vector<Shown<DebugText>> texts_;
};

}  // namespace temblor::server
