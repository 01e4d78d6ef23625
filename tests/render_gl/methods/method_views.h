// Random views of a level by one method, next to the CPU's pictures.
#pragma once

#include "render_gl/gl_pictures.h"
#include "support/pictures/viewpoints.h"

namespace temblor::render_gl {

// Everything that the views show besides the level and its brush models at a random time.
struct ViewContents {
  std::size_t lights = 3;     // at most so many dynamic lights near the eye
  bool with_marks = false;    // in every second view
  bool with_fog = false;      // in every fourth view; in every eighth, in parallel projection
  bool with_opacity = false;  // liquids, and in every third view brush models
  bool with_turns = false;    // brush models have moved and turned
  bool with_styles = false;   // every light style has a random value
};

// The same view for the same number. Its scene refers to `level`, and to the viewpoint.
struct NumberedView {
  NumberedView(const world::Level& level, int number, const ViewContents& contents);
  NumberedView(const NumberedView&) = delete;

  test::Viewpoint viewpoint;
  render::Scene scene;
};

// The share of equal pixels (RendererPair::compare) of views 0 to count - 1.
struct EqualShares {
  double mean = 0, worst = 1;
};
EqualShares compare_views(RendererPair& pair, const test::DrawableLevel& drawable, WorldMethod method,
                          int count, const ViewContents& contents, int tolerance = 2);

}  // namespace temblor::render_gl
