// Several views of one level, drawn at once: for split screens, thumbnails, and programs that learn to play.
//
// Each thread draws one view after the other, from start to finish, because a small picture has too little
// work to be divided. Only the surface cache is shared: threads look up its blocks one at a time, build those
// that are missing, and wait for blocks that another thread is building.
#pragma once

#include <span>

#include "render/frame/frame_caches.h"
#include "render/renderer.h"

namespace temblor::render {

// See Renderer::render_views. `settings.threads` is the number of threads for all views together.
void render_views(std::span<const View> views, const Settings& settings, FrameCaches& io_caches);

}  // namespace temblor::render
