// The ArtMaker of `music`: renders a score (score.h) as music/trackNN.ogg, which loops without a gap.
#pragma once

#include <array>
#include <vector>

#include "artgen/art.h"
#include "artgen/sounds/music/score.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// Samples per second.
constexpr double kMusicRate = 32000;

// Returns the left and right channel, each as long as the piece. Notes and echoes that exceed its end wrap
// around to its start.
base::Result<std::array<Signal, 2>> render_score(const Score& score);

base::Result<std::vector<ArtPart>> make_music_file(const ScriptLine& asset);

}  // namespace temblor::artgen
