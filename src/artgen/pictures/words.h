// What the settings of a picture's lines have in common.
#pragma once

#include <string_view>

#include "artgen/pictures/canvas.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen::pictures {

math::Vec2d point_in(Arguments& io_arguments, std::string_view text);  // "X,Y"
math::Vec2d read_point(Arguments& io_arguments);                       // by place
math::Vec2d read_point(Arguments& io_arguments, std::string_view name, math::Vec2d otherwise);
// "gold:0.7", or "gold" for its middle.
Tone read_tone(Arguments& io_arguments, std::string_view name, Tone otherwise);
Ramp read_ramp(Arguments& io_arguments, std::string_view name_of_ramp);
// color=gold:0.8 to=gold:0.4 raise=1.5 grain=0.1 stain=teal:0.5 edge=gray:0 glow=... and so on.
Ink read_ink(Arguments& io_arguments);
Placement read_placement(Arguments& io_arguments);  // at=X,Y turn=DEG scale=N

// Whether the line's word is a shape's.
bool is_shape_word(std::string_view word);
std::string_view shape_words();  // for messages
// What the line draws on a canvas of that size, asked from its arguments; its ink is not.
Outline read_outline(std::string_view word, Arguments& io_arguments, math::Vec2d canvas_size);

}  // namespace temblor::artgen::pictures
