#include "render/screen/overlay_geometry.h"

#include "base/check.h"

namespace temblor::render {

namespace {

void check_stretched(const DrawCommand& command) {
  const formats::Picture& picture = *command.picture;
  CHECK(command.part_x >= 0 && command.part_y >= 0 && command.part_width > 0 && command.part_height > 0 &&
            std::int64_t{command.part_x} + command.part_width <= std::int64_t{picture.width} &&
            std::int64_t{command.part_y} + command.part_height <= std::int64_t{picture.height},
        "{}x{} from {},{} of {}x{}", command.part_width, command.part_height, command.part_x, command.part_y,
        picture.width, picture.height);
}

// Whole numbers of scaled pixels only, and parts inside their pictures.
void check_command(const DrawCommand& command) {
  CHECK(command.area.width >= 0 && command.area.height >= 0, "{}x{}", command.area.width,
        command.area.height);
  if (command.picture == nullptr) return;
  if (is_stretched(command)) return check_stretched(command);
  CHECK(command.scale >= 1, "scale {}", command.scale);
  const formats::Picture& picture = *command.picture;
  const ScreenRect& area = command.area;
  CHECK(area.width % command.scale == 0 && area.height % command.scale == 0, "{}x{} at scale {}", area.width,
        area.height, command.scale);
  CHECK(command.part_x >= 0 && command.part_y >= 0 &&
            std::int64_t{command.part_x} + area.width / command.scale <= std::int64_t{picture.width} &&
            std::int64_t{command.part_y} + area.height / command.scale <= std::int64_t{picture.height},
        "{}x{} from {},{} of {}x{}", area.width / command.scale, area.height / command.scale, command.part_x,
        command.part_y, picture.width, picture.height);
}

}  // namespace

void check_commands(const DrawList& list) {
  for (const DrawCommand& command : list.commands) check_command(command);
}

}  // namespace temblor::render
