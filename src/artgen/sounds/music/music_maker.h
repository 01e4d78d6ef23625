// The word `music`: one piece (score.h) as music/trackNN.ogg, which goes round without a gap.
#pragma once

#include <array>
#include <vector>

#include "artgen/art.h"
#include "artgen/sounds/music/score.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

constexpr double kMusicRate = 32000;

// Left and right: what rings past the end is laid over the beginning.
base::Result<std::array<Signal, 2>> perform(const Score& score);

base::Result<std::vector<ArtPart>> make_music_file(const ScriptLine& thing);

}  // namespace temblor::artgen
