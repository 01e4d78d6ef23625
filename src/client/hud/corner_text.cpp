#include "client/hud/corner_text.h"

#include "client/hud/panel.h"

namespace temblor::client {

void draw_corner_text(const assets::Pictures& pictures, std::string_view text, int line, float text_size,
                      int width, int height, render::DrawList& io_list) {
  const int scale = choose_text_scale(width, height, {.text = text_size});
  const Panel panel(pictures, io_list, width, height, scale);
  const int characters = static_cast<int>(text.size()) + 1;
  panel.draw_text(text, width / scale - characters * kCharacterSide, (line + 1) * kCharacterSide);
}

}  // namespace temblor::client
