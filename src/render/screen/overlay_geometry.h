// The pixels that a command of a DrawList covers, and the part of its picture that they show.
#pragma once

#include <algorithm>
#include <cstdint>

#include "render/draw_list.h"

namespace temblor::render {

// The pixels [x_first, x_end) of the rows [y_first, y_end). 64 bits, because corner plus size may overflow an
// int.
struct OverlayClip {
  std::int64_t x_first, x_end, y_first, y_end;
  bool is_empty() const { return x_first >= x_end || y_first >= y_end; }
};

inline OverlayClip intersect(const OverlayClip& clip, const ScreenRect& area) {
  return {std::max<std::int64_t>(area.x, clip.x_first),
          std::min<std::int64_t>(std::int64_t{area.x} + area.width, clip.x_end),
          std::max<std::int64_t>(area.y, clip.y_first),
          std::min<std::int64_t>(std::int64_t{area.y} + area.height, clip.y_end)};
}

// The pixels of the command within `bounds`.
inline OverlayClip clip_command(const DrawCommand& command, const OverlayClip& bounds) {
  const OverlayClip clip = intersect(bounds, command.area);
  return command.clip ? intersect(clip, *command.clip) : clip;
}

inline bool is_stretched(const DrawCommand& command) {
  return command.part_width != 0;
}

// Whether the picture's detail is drawn in place of its pixels.
inline bool shows_detail(const DrawCommand& command) {
  return command.picture != nullptr && command.picture->detail && command.translation == nullptr;
}

// The size of the part that a command with a picture shows, in pixels of the picture.
struct OverlayPart {
  std::int64_t width, height;
};
inline OverlayPart find_part(const DrawCommand& command) {
  if (is_stretched(command)) return {command.part_width, command.part_height};
  return {command.area.width / command.scale, command.area.height / command.scale};
}

// CHECKs that scaled pictures cover whole numbers of scaled pixels, and that parts are inside their pictures.
void check_commands(const DrawList& list);

}  // namespace temblor::render
