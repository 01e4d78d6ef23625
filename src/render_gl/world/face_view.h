// The values that all programs of faces need in a frame: the view, the time, and the fog.
#pragma once

#include "render_gl/world/face_programs.h"
#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

// Doors may lie in the plane of a wall, which they cover on the CPU. This share of their distance, 0.03 units
// at 1000, is more than what rounding does to either.
constexpr float kBrushModelNearer = 1.0f / 32768;

// Uses the program from now on, with the frame's values. Those of an instance and of a method are set later.
void use_face_program(const Functions& gl, const FrameInput& input, const FaceProgram& program,
                      bool has_color_key);

// Sets the variables of an instance of FrameInput::scene (0: the world) for the program in use.
void set_face_instance(const Functions& gl, const FrameInput& input, const FaceProgram& program,
                       std::uint32_t instance);

}  // namespace temblor::render_gl
