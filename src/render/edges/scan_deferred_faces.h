// Late faces are scanned one at a time, each as if nothing else were on the screen: the pixels that the edge
// list would give it.
#pragma once

#include <span>

#include "render/edges/scan_band.h"

namespace temblor::render {

// `spans` of a band, and behind them those of each late surface, from the top, each row's from left to right.
std::span<const ItemSpan> with_deferred_faces(std::span<const ItemSpan> spans, const EdgeTable& table,
                                              int first_row, int row_count, int width, base::Arena& arena);

}  // namespace temblor::render
