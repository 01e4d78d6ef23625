// The beam tree: a BSP tree of the screen, made of the outlines of all faces so far, which are taken from
// front to back. A new face is pushed down the tree and split by its lines. Parts in covered leaves are
// hidden. Parts in open leaves are visible, and their outlines divide these leaves further:
//
//     +-----a-----------+            a              Face A covers a corner of the screen. A new face is split
//     |  A   \          |      left / \ right       by edge a. Its part at the right is visible, and divides
//     |       \   open  |          b   open         the leaf there. Its part at the left is split by edge b,
//     |---b----\        |         / \               and the part in leaf A is hidden.
//     |  open   \       |        A   open
//     +-----------------+
//
// When both sides of a line are covered, the line is no longer needed.
//
// Method: described by Michael Abrash, "Consider the Alternatives: Quake's Hidden-Surface Removal", which
// names its faults: much work, and far more of it in the worst views. Here, parts of faces are spans of whole
// pixels (beam_tree/pixel_region.h) in place of polygons, so that the picture has no cracks.
//
// Parameter `bands` 1 makes one tree for each band of rows, by several threads; 0 makes one tree for the
// frame. Parameter `nodes` is the most nodes that the trees of a frame may have together; each tree has a
// share by its rows. Comparisons and memory have limits in proportion. When a tree reaches one of them, it is
// replaced by one bit for each pixel that is still open, and the remaining faces are clipped against these
// bits span by span. Counts::spans_sorted counts such spans: it is 0 if no tree was too large. The picture is
// the same either way.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_beam_tree(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
