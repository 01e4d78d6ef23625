// Stage 11. A DrawList -> pixels: pictures and rectangles over the finished view.
#pragma once

#include "render/colour/colour_tables.h"
#include "render/draw_list.h"
#include "render/frame.h"

namespace temblor::render {

// Renderer::draw_overlay.
void draw_overlay(const DrawList& list, const ColourTables& tables, FrameBuffer& io_frame);

}  // namespace temblor::render
