// Films of a few seconds as animated PNG files, which browsers show without scripts. Other programs show the
// first frame.
#pragma once

#include <span>

#include "base/bytes.h"
#include "base/result.h"

namespace temblor::formats {

// `frames`: whole PNG files from write_png(), all of the same size and color type. The film repeats forever,
// and each frame is shown for 1 / frames_per_second. CHECKs that there is a frame, and that the files are as
// write_png() makes them.
//
// Source: "Portable Network Graphics (PNG) Specification (Third Edition)", W3C, sections 4.9 and 11.3.
base::ByteVector join_png_frames(std::span<const base::ByteVector> frames, int frames_per_second);

}  // namespace temblor::formats
