// Alias models put together from boxes, as small stand-ins for what a game shows: to be looked at.
#pragma once

#include <span>
#include <vector>

#include "artgen/palette.h"
#include "formats/models/mdl.h"

namespace temblor::test {

// Units, model space. Its sides are painted with a frame and a checker in that ramp.
struct ModelBox {
  math::Bounds bounds;
  artgen::Ramp ramp;
};

// One pose for each frame; all frames have the same number of boxes in the same colors, at least one.
formats::Mdl model_of_boxes(std::span<const std::vector<ModelBox>> frames);

// Two legs, a trunk and a head, 56 units high, its feet 24 below its origin, looking along +x. Four frames of
// a walk. Trunk and legs are in the colors that players choose.
formats::Mdl walker_mdl();
// Held as weapons are: its origin is the eye. Frame 0 at rest, 1 to 3 kicking back.
formats::Mdl weapon_mdl();
// 24 units long, with the trail of a rocket.
formats::Mdl rocket_mdl();
// A piece of lightning: 30 units along +x.
formats::Mdl bolt_mdl();

}  // namespace temblor::test
