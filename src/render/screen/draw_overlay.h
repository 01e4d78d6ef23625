// Stage 11. A DrawList -> pixels: pictures and rectangles over the finished view.
#pragma once

#include "base/parallel_for.h"
#include "render/color/color_tables.h"
#include "render/draw_list.h"
#include "render/frame.h"

namespace temblor::render {

// Renderer::draw_overlay. Without jobs in place; the same pixels.
void draw_overlay(const DrawList& list, const ColorTables& tables, base::Jobs* jobs, FrameBuffer& io_frame);

}  // namespace temblor::render
