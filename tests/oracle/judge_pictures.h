// Draws random views of a level and holds each against the oracle.
#pragma once

#include "oracle/comparison.h"
#include "support/levels/drawable_level.h"

namespace temblor::oracle {

struct Pictures {
  render::PixelFormat format = render::PixelFormat::kIndexed;
  render::Projection projection = render::Projection::kPerspective;
  int views = 1;
};

// Views of 640 x 480, 500 random pixels each. Every second one has its brush models moved; of both kinds,
// every second one is drawn without the PVS. A view with a wrong face is held against the oracle whole and is
// a test failure. The same views for the same level.
Tally judge_pictures(const test::DrawableLevel& drawable, const Pictures& pictures);

// What every level must reach (the figures are the project's own): face >= 99.9 %, none wrong away from
// edges, color and depth >= 99.5 %.
void expect_right(const Tally& tally);

}  // namespace temblor::oracle
