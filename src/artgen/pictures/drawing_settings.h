// Readers for the settings that lines of pictures share: points, tones, ink, placements, and the shapes
// themselves. Problems are recorded in the arguments (scripts/script.h), and a default is returned.
#pragma once

#include <string_view>

#include "artgen/pictures/canvas.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen::pictures {

// "X,Y"
math::Vec2d parse_point(Arguments& io_arguments, std::string_view text);
// The next positional value.
math::Vec2d read_point(Arguments& io_arguments);
math::Vec2d read_point(Arguments& io_arguments, std::string_view name, math::Vec2d fallback);
// "gold:0.7", or "gold" for the middle of the ramp.
Tone read_tone(Arguments& io_arguments, std::string_view name, Tone fallback);
// Looks up a ramp's name.
Ramp read_ramp(Arguments& io_arguments, std::string_view name_of_ramp);
// All settings of an ink: color=gold:0.8 to=gold:0.4 raise=1.5 grain=0.1 stain=teal:0.5 edge=gray:0 glow=...,
// and so on.
Ink read_ink(Arguments& io_arguments);
// at=X,Y turn=DEG scale=N
Placement read_placement(Arguments& io_arguments);

// Whether the keyword draws a shape.
bool is_shape_keyword(std::string_view word);
// A list of all shapes, for error messages.
std::string_view shape_keywords();
// Reads the shape of a line, but not its ink. `word` must be a shape keyword. `canvas_size` limits shapes
// that fill the canvas.
Outline read_outline(std::string_view word, Arguments& io_arguments, math::Vec2d canvas_size);

}  // namespace temblor::artgen::pictures
