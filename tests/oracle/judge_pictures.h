// Draws random views of a level and compares each with the oracle.
#pragma once

#include "oracle/comparison.h"
#include "support/levels/drawable_level.h"

namespace temblor::oracle {

struct Pictures {
  render::PixelFormat format = render::PixelFormat::kIndexed;
  render::Projection projection = render::Projection::kPerspective;
  int views = 1;
  const render::FrameStages* stages = nullptr;  // null: the engine's own
  bool may_be_wrong = false;                    // wrong faces are counted, but do not fail the test
};

// Views of 640 x 480, 500 random pixels each. Every second view has its brush models moved, and half of each
// kind is drawn without the PVS. A view with a wrong face is compared completely and fails the test. The
// views are the same for the same level.
Tally judge_pictures(const test::DrawableLevel& drawable, const Pictures& pictures);

// The required results, set by this project: face >= 99.9 %, none wrong away from edges, color and depth >=
// 99.5 %.
void expect_right(const Tally& tally);

}  // namespace temblor::oracle
