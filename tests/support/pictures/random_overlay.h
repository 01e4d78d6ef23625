// Random commands of a DrawList, with all that a command can have.
#pragma once

#include "render/draw_list.h"
#include "support/random.h"

namespace temblor::test {

// A third of it transparent; 1 to 40 pixels on a side.
formats::Picture random_picture(Random& random);
// Gives the picture a detail of random size, a third of it opaque, and a third clear.
void add_detail(formats::Picture& io_picture, Random& random);
render::ColorTranslation random_translation(Random& random);
render::ColorTint random_color_tint(Random& random);

// Around the edges of a frame of about 100 x 100 pixels, or far away; the arguments must outlive it.
render::DrawCommand random_command(const formats::Picture& picture,
                                   const render::ColorTranslation& translation, Random& random);
// Some commands get the tint, some are clipped, and some add or multiply.
void decorate_command(render::DrawCommand& io_command, const render::ColorTint& tint, Random& random);

}  // namespace temblor::test
