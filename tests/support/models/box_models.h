// Alias models built from boxes: small placeholders for the models of a game, in pictures for people.
#pragma once

#include <span>
#include <vector>

#include "artgen/palette.h"
#include "formats/models/mdl.h"

namespace temblor::test {

// A box in model space, in units. Its sides have a frame and a checkerboard in the colors of a ramp.
struct ModelBox {
  math::Bounds bounds;
  artgen::Ramp ramp;
};

// Makes one pose for each frame. All frames must have the same boxes in the same colors, at least one.
formats::Mdl make_box_model(std::span<const std::vector<ModelBox>> frames);

// A figure with two legs, a trunk, and a head, 56 units high, with its feet 24 below the origin, looking
// along +x. Four frames of walking. Trunk and legs have the colors that players choose.
formats::Mdl walker_mdl();
// A weapon as the player sees it: its origin is the eye. Frame 0 at rest, 1 to 3 kicking back.
formats::Mdl weapon_mdl();
// A rocket, 24 units long, with a trail.
formats::Mdl rocket_mdl();
// A segment of lightning: 30 units along +x.
formats::Mdl bolt_mdl();

}  // namespace temblor::test
