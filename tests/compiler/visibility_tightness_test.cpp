// How much is drawn for nothing: the area of faces that our visibility lets through, beside the finished
// level's.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/sight_lines.h"
#include "compiler/tree_portals.h"
#include "compiler/visibility.h"
#include "compiler/visibility_lump.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "world/visibility.h"

namespace temblor::compiler {
namespace {

std::vector<double> areas_of_faces(const world::Level& level) {
  std::vector<double> areas;
  for (const world::Face& face : level.faces) {
    const auto corner = [&](std::uint32_t i) {
      return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
    };
    math::Vec3d twice_area{0.0};
    for (std::uint32_t i = 2; i < face.surfedge_count; ++i)
      twice_area += glm::cross(corner(i - 1) - corner(0), corner(i) - corner(0));
    areas.push_back(glm::length(twice_area) / 2);
  }
  return areas;
}

// Of the faces of all leafs that the leaf sees, each once.
double visible_area(const world::Level& level, world::LeafIndex from, const std::vector<double>& areas) {
  std::vector<std::uint8_t> row;
  world::decompress_pvs(level, from, row);
  std::vector<bool> counted(areas.size(), false);
  double sum = 0;
  for (std::size_t i = 1; i < level.leafs.size(); ++i) {
    if (!world::pvs_has(row, base::to_index<world::LeafIndex>(i))) continue;
    const world::Leaf& leaf = level.leafs[i];
    for (std::uint32_t k = 0; k < leaf.marked_face_count; ++k) {
      const std::size_t face = base::to_size(level.marked_faces[leaf.first_marked_face + k]);
      if (!counted[face]) sum += areas[face];
      counted[face] = true;
    }
  }
  return sum;
}

TEST(VisibilityTightness, LetsThroughNoMoreThanFinishedLevelsDo) {
  DATA_FOLDER_OR_SKIP(folder);
  const std::vector<std::string> names =
      test::kQuick ? std::vector<std::string>{"start"}
                   : std::vector<std::string>{"start", "lq_e0m1", "lq_e1m2", "lqdm5"};
  for (const std::string& name : names) {
    const formats::Bsp theirs = finished_level(folder, name);
    const PortalSet portals = make_tree_portals(theirs, {.clusters = Clusters::kSharedVisibility}).value();
    base::Jobs jobs(2);
    VisibilityState state = begin_visibility(portals);
    continue_visibility(
        portals, jobs, [](std::size_t, std::size_t) { return true; }, state);
    formats::Bsp ours = theirs;
    ASSERT_TRUE(write_visibility(portals, visible_clusters(portals, state), {}, ours).ok());

    const auto our_level = world::make_level(ours, name).value();
    const auto their_level = world::make_level(theirs, name).value();
    const std::vector<double> areas = areas_of_faces(*our_level);
    test::Random random(1);
    double our_area = 0, their_area = 0;
    for (int i = 0; i < test::effort(1000, 30); ++i) {
      const auto point = random_open_point(theirs, random);
      ASSERT_TRUE(point);
      const auto leaf = base::to_index<world::LeafIndex>(leaf_at(theirs, *point));
      our_area += visible_area(*our_level, leaf, areas);
      their_area += visible_area(*their_level, leaf, areas);
    }
    RecordProperty(name, std::to_string(our_area / their_area));
    EXPECT_LE(our_area, 1.05 * their_area) << name;
    EXPECT_GT(our_area, 0.5 * their_area) << name << ": so little that something must be missing";
  }
}

}  // namespace
}  // namespace temblor::compiler
