#include "app/lab/space_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/commands/command_line.h"
#include "app/files/atomic_write.h"
#include "app/files/picture_file.h"
#include "app/lab/space_figures.h"
#include "app/lab/space_window.h"
#include "base/text.h"

namespace temblor::app {
namespace {

using base::ErrorCode;
using lab::space::BattleShapes;
using lab::space::DepthSorting;

constexpr std::size_t kDefaultSolids = 100;
constexpr double kMinSpacing = 0.5, kMaxSpacing = 20;

base::Result<BattleShapes> parse_shapes(std::string_view text) {
  for (const BattleShapes shapes : {BattleShapes::kConvex, BattleShapes::kConcave, BattleShapes::kBoth})
    if (text == shapes_name(shapes)) return shapes;
  return base::error(ErrorCode::kUsage, "\"{}\" is not convex, concave, or both", text);
}

base::Result<DepthSorting> parse_sorting(std::string_view text) {
  for (const DepthSorting sorting :
       {DepthSorting::kIndependent, DepthSorting::kAbutting, DepthSorting::kIntersecting})
    if (text == sorting_name(sorting)) return sorting;
  return base::error(ErrorCode::kUsage, "\"{}\" is not independent, abutting, or intersecting", text);
}

base::Status write_space_picture(const SpaceScene& scene, const std::string& out) {
  TRY(const std::string path, numbered_name(out, 0));
  return write_picture_file(path, draw_space(scene), {});
}

}  // namespace

std::string SpaceOptions::find_given() const {
  return solids ? "--solids" : shapes ? "--shape" : sorting ? "--sorting" : spacing ? "--spacing" : "";
}

void add_space_options(Command& command, SpaceOptions& io_options) {
  command.add_option("--solids", io_options.solids, "space: number of solids, 1 to 10000 (default: 100)")
      ->type_name("N")
      ->check(in_range(1, static_cast<int>(lab::space::kMaxSolids)));
  add_parsed_option(command, "--shape", io_options.shapes, parse_shapes,
                    "space: convex, concave, or both (default: convex)")
      ->type_name("SHAPE");
  add_parsed_option(command, "--sorting", io_options.sorting, parse_sorting,
                    "space: independent, abutting, or intersecting (default: independent)")
      ->type_name("TYPE");
  command
      .add_option("--spacing", io_options.spacing,
                  "space: distance between solids in radii; below 3, they may intersect (default: 3)")
      ->type_name("RADII")
      ->check(in_range(kMinSpacing, kMaxSpacing));
}

base::Status run_space(const SpaceOptions& options, const FrameOptions& frame, bool json,
                       const std::string& out) {
  const lab::space::BattleOptions defaults;
  const SpaceScene scene{
      .battle = {.solids = static_cast<std::size_t>(options.solids.value_or(kDefaultSolids)),
                 .shapes = options.shapes.value_or(defaults.shapes),
                 .spacing = options.spacing.value_or(defaults.spacing),
                 .sorting = options.sorting.value_or(defaults.sorting)},
      .size = frame.size,
      .fov_deg = frame.fov_deg};
  const bool is_plot = base::to_lower(out).ends_with(".svg");
  if (!out.empty() && !is_plot && !base::to_lower(out).ends_with(".png"))
    return base::error(ErrorCode::kUnsupported, "-o {}: space writes a picture (.png) or a plot (.svg)", out);
  if (is_plot)
    TRY_STATUS(replace_file(
        out, base::as_bytes(draw_svg_file(plot_space_curves(scene, measure_space_curves(scene))))));
  else if (!out.empty())
    TRY_STATUS(write_space_picture(scene, out));
  if (json) {
    constexpr std::array<std::size_t, 4> kCounts = {10, 100, 1000, lab::space::kMaxSolids};
    const std::span<const std::size_t> all = kCounts, chosen(&scene.battle.solids, 1);
    fmt::print("{}\n", make_space_json(scene, measure_space(scene, options.solids ? chosen : all)));
  }
  if (json || !out.empty()) return base::Ok{};
  return play_space(scene);
}

std::string describe_space() {
  return fmt::format(
      "{}: {}\n  {}\n  From \"Sorted Spans in Action\", 1/z span sorting in action. Replaces: the whole "
      "frame.\n  Expected: {}\n",
      kSpaceName, kSpaceTitle, kSpaceSummary, kSpaceExpected);
}

}  // namespace temblor::app
