// `temblor lab run space`: the space battle in a window, as a picture, or as figures.
#pragma once

#include <optional>
#include <string>

#include "app/commands/options.h"
#include "base/result.h"
#include "lab/space_battle.h"

namespace temblor::app {

class Command;

// The scene's name, where `lab run` takes that of a technique.
constexpr const char* kSpaceName = "space";
// For `lab list`.
constexpr const char *kSpaceTitle = "The sorted-spans sample, a space battle",
                     *kSpaceSummary =
                         "Moving solids before stars, drawn with edges sorted by 1/z, without a "
                         "level. You can fly through it.",
                     *kSpaceExpected =
                         "One comparison per pair is enough for solids that never touch, convex "
                         "or concave.";

// Nothing: not given.
struct SpaceOptions {
  std::optional<int> solids;
  std::optional<lab::space::BattleShapes> shapes;
  std::optional<lab::space::DepthSorting> sorting;
  std::optional<double> spacing;

  // The name of an option that was given; empty if there is none.
  std::string find_given() const;
};

void add_space_options(Command& command, SpaceOptions& io_options);

// `out`: a .png for a picture, a .svg for the cost curve, or empty. With `json`, prints figures. Without
// both, opens a window. Errors: no display, another file name, a file that cannot be written.
base::Status run_space(const SpaceOptions& options, const FrameOptions& frame, bool json,
                       const std::string& out);

// The paragraph of `lab list`.
std::string describe_space();

}  // namespace temblor::app
