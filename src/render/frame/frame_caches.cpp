#include "render/frame/frame_caches.h"

#include <algorithm>

namespace temblor::render {

namespace {

// Contents are numbered downward from water; sky is among them.
bool has_liquid_leaf(const world::Level& level) {
  return std::ranges::any_of(level.leaves, [](const world::Leaf& leaf) {
    return leaf.contents <= world::Contents::kWater && leaf.contents != world::Contents::kSky;
  });
}

}  // namespace

LevelData::LevelData(const world::Level& level, const ColorTables& colors)
    : identity(level.identity),
      has_liquid(has_liquid_leaf(level)),
      tables(make_level_tables(level)),
      outlines(make_face_outlines(level)),
      cutouts(level, colors),
      water_faces(level) {}

void ViewCaches::prepare(const LevelData& level, const FrameBuffer& frame) {
  // In every frame, since the frame's size may change: the first frame under water must not wait for memory.
  if (level.has_liquid) warp.prepare(frame);
  arenas.frame.reset();
}

void FrameCaches::prepare(const Scene& scene, const Settings& settings) {
  if (!jobs || jobs->threads() != settings.threads || job_backend != settings.job_backend) {
    jobs.emplace(settings.threads, settings.job_backend);
    job_backend = settings.job_backend;
  }
  if (level.identity != scene.level->identity) level = LevelData(*scene.level, colors);
  if (has_marks(scene) && !mark_tables) mark_tables.emplace(colors);
}

}  // namespace temblor::render
