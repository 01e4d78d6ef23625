// The ArtMaker of `music`: renders a score (score.h) as music/trackNN.ogg, which loops without a gap, and its
// combat layer as music/trackNN_combat.ogg.
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
// Renders the combat layer, to be added to both channels of the piece again and again. `piece`: the result of
// render_score(). Where the sum would get close to full scale, the layer is softened for a moment.
base::Result<Signal> render_combat_layer(const Score& score, const std::array<Signal, 2>& piece);

base::Result<std::vector<ArtPart>> make_music_file(const ScriptLine& asset);

}  // namespace temblor::artgen
