// All maps of the game data, checked by rays and boxes against their brushes: they are sealed, each hull
// agrees with the brushes, and no line of sight is lost. Rays from entities find places inside.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "compiler/compiled_maps.h"
#include "compiler/random/level_checks.h"
#include "compiler/vis/sight_lines.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/random.h"
#include "world/level.h"

namespace temblor::test {
namespace {

using math::Vec3d;

// The part of a ray, in its own length, before it comes near a solid; nothing: it does not.
std::optional<double> find_contact(const Solid& solid, const Vec3d& start, const Vec3d& along) {
  double enter = 0, leave = 1e9;
  for (std::size_t i = 0; i < solid.normals.size() && enter <= leave; ++i) {
    const double above = glm::dot(solid.normals[i], start) - solid.distances[i] - kUnsure;
    const double speed = glm::dot(solid.normals[i], along);
    if (std::abs(speed) < 1e-12) {
      if (above > 0) return std::nullopt;
    } else if (speed < 0) {
      enter = std::max(enter, -above / speed);
    } else {
      leave = std::min(leave, -above / speed);
    }
  }
  return enter <= leave ? std::optional(enter) : std::nullopt;
}

class StockMapChecker {
 public:
  // `is_box`: a box of ammunition, which is seen from outside.
  StockMapChecker(const formats::Map& map, const std::string& name, bool is_box)
      : is_box_(is_box),
        solids_(solids_of_world(map)),
        result_(compile_map(map, 2)),
        level_(world::make_level(result_.draft.bsp, name).value()) {
    for (const Solid& solid : solids_) {
      mins_ = glm::min(mins_, solid.mins);
      maxs_ = glm::max(maxs_, solid.maxs);
    }
    for (const formats::MapEntity& entity : map.entities)
      if (const auto origin = entity.fields.find_vec3("origin"); origin && entity.brushes.empty() && !is_box)
        if (const Vec3d at(*origin); depth_in_any(solids_, kHullBoxes.front().second, at) < -kUnsure)
          places_.push_back(at);
  }

  void run(int rays, bool has_full_search) {
    if (!is_box_) {
      ASSERT_FALSE(result_.leak);
      base::Jobs jobs(2);
      const compiler::PortalSet& portals = result_.draft.portals;
      visible_ = has_full_search ? find_visibility(portals, 2)
                                 : compiler::find_roughly_visible_clusters(portals, jobs);
      for (int i = 0; i < rays; ++i) follow_ray();
    }
    for (int i = 0; i < rays; ++i) check_brush();
    for (int i = 0; i < rays; ++i) check_outside();
    EXPECT_TRUE(is_box_ || inside_ > rays / 2);
    EXPECT_GT(in_brushes_, rays / 2);
    EXPECT_GT(outside_, rays / 20);
  }
  int wrong() const { return wrong_; }

 private:
  // How far a ray gets; nothing: it leaves the level.
  std::optional<double> find_end(const Vec3d& start, const Vec3d& along) const {
    std::optional<double> nearest;
    for (const Solid& solid : solids_)
      if (const auto contact = find_contact(solid, start, along);
          contact && (!nearest || *contact < *nearest))
        nearest = contact;
    return nearest;
  }

  void expect_solid(bool expected, world::Hull hull, const Vec3d& at, const char* where) {
    if (is_solid(*level_, hull, at) == expected || ++wrong_ > 5) return;
    ADD_FAILURE() << "hull " << static_cast<int>(hull) << " at " << at.x << ' ' << at.y << ' ' << at.z << ", "
                  << where << ", is " << (expected ? "open" : "solid");
  }

  // From a place inside in any direction, as far as it goes: everything on the way is inside and visible.
  void follow_ray() {
    const Vec3d start = places_[random_.below(places_.size())];
    const Vec3d along = glm::normalize(Vec3d(random_.in_cube(1)));
    const std::optional<double> end = find_end(start, along);
    if (!end) {
      ++wrong_;
      ADD_FAILURE() << "a ray leaves the level from " << start.x << ' ' << start.y << ' ' << start.z;
      return;
    }
    if (*end < 1) return;
    const Vec3d at(math::Vec3(start + along * random_.uniform(0, *end)));
    places_.push_back(at);
    for (const auto& [hull, box] : kHullBoxes) {
      const double depth = depth_in_any(solids_, box, at);
      if (std::abs(depth) < kUnsure) continue;
      ++inside_;
      expect_solid(depth > 0, hull, at, "inside");
    }
    const auto& clusters = result_.draft.portals.cluster_of_leaf;
    const auto from = clusters[compiler::leaf_at(result_.draft.bsp, start)],
               to = clusters[compiler::leaf_at(result_.draft.bsp, at)];
    if (from == compiler::kNoCluster || to == compiler::kNoCluster || visible_.at(from, to)) return;
    ++wrong_;
    ADD_FAILURE() << start.x << ' ' << start.y << ' ' << start.z << " does not see " << at.x << ' ' << at.y
                  << ' ' << at.z;
  }

  void check_brush() {
    const Solid& solid = solids_[random_.below(solids_.size())];
    if (solid.corners.empty()) return;
    Vec3d at(0.0);
    double total = 0;
    for (const Vec3d& corner : solid.corners) {
      const double weight = random_.uniform(0, 1);
      at += corner * weight;
      total += weight;
    }
    at = Vec3d(math::Vec3(at / total));
    for (const auto& [hull, box] : kHullBoxes) {
      if (depth_in(solid, box, at) < kUnsure || (hull == world::Hull::kPoint && !solid.stops_points))
        continue;
      ++in_brushes_;
      expect_solid(true, hull, at, "in a brush");
    }
  }

  // A place from which a ray leaves the level is outside.
  void check_outside() {
    Vec3d at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = random_.uniform(mins_[axis] - 64, maxs_[axis] + 64);
    at = Vec3d(math::Vec3(at));
    if (find_end(at, glm::normalize(Vec3d(random_.in_cube(1))))) return;
    for (const auto& [hull, box] : kHullBoxes) {
      if (depth_in_any(solids_, box, at) > -kUnsure) continue;
      ++outside_;
      expect_solid(!is_box_, hull, at, "outside");
    }
  }

  Random random_{23};
  bool is_box_;
  std::vector<Solid> solids_;
  compiler::DraftResult result_;
  std::shared_ptr<const world::Level> level_;
  compiler::BitMatrix visible_;
  std::vector<Vec3d> places_;  // inside
  Vec3d mins_{1e9}, maxs_{-1e9};
  int inside_ = 0, in_brushes_ = 0, outside_ = 0, wrong_ = 0;
};

class StockMapChecks : public ::testing::TestWithParam<const char*> {};

TEST_P(StockMapChecks, AgreeWithTheBrushes) {
  DATA_FOLDER_OR_SKIP(data);
  const std::string name = GetParam();
  // The full search of these takes half a minute; side_by_side_test.cpp runs it and looks for holes.
  const bool is_large = name == "lqdm5" || name == "lq_e1m2";
  StockMapChecker checker(read_stock_map(data, name), name, name.starts_with("b_"));
  checker.run(effort(6000, 300), !is_large);
  EXPECT_EQ(checker.wrong(), 0);
}

INSTANTIATE_TEST_SUITE_P(All, StockMapChecks, ::testing::ValuesIn(stock_maps()),
                         [](const auto& map) { return std::string(map.param); });

}  // namespace
}  // namespace temblor::test
