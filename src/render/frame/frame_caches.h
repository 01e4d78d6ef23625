// Everything that the renderer keeps from frame to frame: tables of the level, the surface cache, and memory.
// Pixels never depend on it; an empty cache only makes a frame slower.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/parallel_for.h"
#include "render/color/fog.h"
#include "render/edges/face_outlines.h"
#include "render/screen/warp.h"
#include "render/spans/skybox.h"
#include "render/surfaces/cutout_textures.h"
#include "render/surfaces/light/caustics.h"
#include "render/surfaces/paint_marks.h"
#include "render/surfaces/surface_cache.h"
#include "render/view/frame_context.h"
#include "render/view/level_tables.h"

namespace temblor::render {

// Computed when a level is drawn for the first time; depends on nothing but the level and the palette.
struct LevelData {
  LevelData() = default;
  LevelData(const world::Level& level, const ColorTables& colors);

  std::shared_ptr<const world::LevelIdentity> identity;  // null: no level yet
  // The level has a leaf to dive in, so the underwater warp may be needed.
  bool has_liquid = false;
  LevelTables tables;
  FaceOutlines outlines;
  CutoutTextures cutouts;
  WaterFaces water_faces;
};

// The memory of one view while it is drawn. Views that are drawn at the same time share everything else.
struct ViewCaches {
  // Prepares for a frame of this size and format.
  void prepare(const LevelData& level, const FrameBuffer& frame);

  FrameArenas arenas;
  FogTables fog_tables;
  Warp warp;
};

struct FrameCaches {
  explicit FrameCaches(ColorTables game_colors) : colors(std::move(game_colors)) {}

  // Prepares everything but the views' own memory. Costs next to nothing when level and threads are those of
  // the previous frame.
  void prepare(const Scene& scene, const Settings& settings);

  ColorTables colors;
  // Made when a scene has marks for the first time: it takes milliseconds.
  std::optional<MarkTables> mark_tables;
  // None before the first frame. Owns the worker threads.
  std::optional<base::Jobs> jobs;
  base::JobBackend job_backend{};
  LevelData level;
  SurfaceCache surfaces;
  PreparedSkybox skybox;
  // For a frame that is drawn alone, and by thread for those that are drawn at once (render_views.h).
  ViewCaches view;
  std::vector<ViewCaches> views;
};

}  // namespace temblor::render
