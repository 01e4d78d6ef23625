// Models through an edge list: their triangles become edges and spans, as the world's faces do, and each
// pixel is drawn once. Spans are tested against the world's depth only.
//
// The list is the models' own, because the world's is sorted by BSP order, which models do not have.
//
// Parameter `tree`: 0: the edges of a row form a linked list; 1: a balanced tree.
// Parameter `triangles`: scenes with more triangles in their models are refused.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_models_in_edges(std::span<const double> values, Counter* counter);
base::Status check_models_in_edges(std::span<const double> values, const render::Scene& scene);

}  // namespace temblor::lab
