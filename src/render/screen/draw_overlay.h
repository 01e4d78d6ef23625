// Stage 11. DrawList -> pixels: pictures and rectangles over the finished view.
#pragma once

#include "base/parallel_for.h"
#include "render/color/color_tables.h"
#include "render/draw_list.h"
#include "render/frame_buffer.h"

namespace temblor::render {

// Implements Renderer::draw_overlay. Without `jobs` it draws on the calling thread; the pixels are the same.
void draw_overlay(const DrawList& list, const ColorTables& tables, base::Jobs* jobs, FrameBuffer& io_frame);

}  // namespace temblor::render
