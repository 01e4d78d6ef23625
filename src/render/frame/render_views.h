// Several views of one level, drawn at once: for split screens, thumbnails, and programs that learn to play.
//
//   each view, in parallel:  find the surfaces that its spans need
//   one thread:              look all of them up in the shared cache, and reserve the missing ones
//   in parallel:             build the missing ones
//   each view, in parallel:  draw
//
// A view is drawn by one thread, because a small picture has too little work to be divided.
#pragma once

#include <span>

#include "render/frame/frame_caches.h"
#include "render/renderer.h"

namespace temblor::render {

// See Renderer::render_views. `settings.threads` is the number of threads for all views together.
void render_views(std::span<const View> views, const Settings& settings, FrameCaches& io_caches);

}  // namespace temblor::render
