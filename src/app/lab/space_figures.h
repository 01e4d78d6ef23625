// Measurements of the space battle: its cost against the number of solids.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/html/plot.h"
#include "lab/space_battle.h"
#include "render/frame_buffer.h"

namespace temblor::app {

// Medians of frames from the lookout, while the battle goes on, on one thread. The time is the best of three
// rounds, because other programs disturb some.
struct SpaceFigures {
  std::size_t solids = 0;
  double ms = 0;
  double edges = 0, surfaces = 0, spans = 0, comparisons = 0;
  double depth_complexity = 0;  // surfaces that cover a pixel, without the background

  double ns_per_edge() const { return edges > 0 ? ms * 1e6 / edges : 0; }
};

struct SpaceScene {
  lab::space::BattleOptions battle;
  FrameSize size{640, 480};
  double fov_deg = 90;
};

// The view that is measured, and that a window begins with.
lab::space::BattleView make_lookout_view(const lab::space::Battle& battle, const SpaceScene& scene);

// The battle at time 0.
render::FrameBuffer draw_space(const SpaceScene& scene);

// One for each number of solids. Each takes about half a second at most.
std::vector<SpaceFigures> measure_space(const SpaceScene& scene, std::span<const std::size_t> solids);

const char* shapes_name(lab::space::BattleShapes shapes);
const char* sorting_name(lab::space::DepthSorting sorting);

std::string make_space_json(const SpaceScene& scene, std::span<const SpaceFigures> figures);

// Convex and concave solids, from 10 to the most.
struct SpaceCurve {
  lab::space::BattleShapes shapes;
  std::vector<SpaceFigures> figures;
};
std::vector<SpaceCurve> measure_space_curves(SpaceScene scene);
Plot plot_space_curves(const SpaceScene& scene, std::span<const SpaceCurve> curves);

}  // namespace temblor::app
