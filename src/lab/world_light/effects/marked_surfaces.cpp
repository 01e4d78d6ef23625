#include "lab/world_light/effects/marked_surfaces.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "base/hash.h"
#include "render/surfaces/paint_marks.h"

namespace temblor::lab {

namespace {

// The marks of a level's faces, and the tables that paint them.
class LevelMarks {
 public:
  explicit LevelMarks(std::size_t per_face) : per_face_(per_face) {}

  void begin_level(const world::Level& level) {
    if (level_ == level.identity) return;
    level_ = level.identity;
    marks_.clear();
    for (std::uint32_t face = 0; face < level.faces.size(); ++face) add_marks(level, face);
  }
  std::span<const render::Mark> on_face(world::FaceIndex face) const {
    return std::span(marks_).subspan(base::to_size(face) * per_face_, per_face_);
  }
  const render::MarkTables& tables(const render::ColorTables& colors) {
    if (!tables_ || palette_ != colors.palette) {
      palette_ = colors.palette;
      tables_.emplace(colors);
    }
    return *tables_;
  }

 private:
  // At random points between three corners of the face.
  void add_marks(const world::Level& level, std::uint32_t number) {
    const world::Face& face = level.faces[number];
    std::uint64_t hash = number;
    const auto draw_number = [&] {
      return static_cast<double>((hash = base::hash_with(hash, 1)) >> 40) * 0x1p-24;
    };
    const auto draw_corner = [&] {
      const auto corner = static_cast<std::uint32_t>(draw_number() * face.surfedge_count);
      return level.vertices[level.surfedge_start(face.first_surfedge + corner)];
    };
    for (std::size_t i = 0; i < per_face_; ++i) {
      render::Mark mark;
      mark.kind = static_cast<render::MarkKind>(i % render::MarkShapes::kKinds);
      mark.position_model = draw_corner();
      for (const float share : {0.5f, 0.6f})
        mark.position_model += (draw_corner() - mark.position_model) * share;
      mark.radius = static_cast<float>(4 + 20 * draw_number());
      mark.seed = static_cast<std::uint32_t>(hash);
      marks_.push_back(mark);
    }
  }

  const std::size_t per_face_;
  std::shared_ptr<const world::LevelIdentity> level_;
  std::vector<render::Mark> marks_;  // per_face_ for each face
  formats::Palette palette_{};
  std::optional<render::MarkTables> tables_;
};

}  // namespace

render::FrameStages make_marked_surfaces(std::span<const double> values, Counter* /*counter*/) {
  const auto marks = std::make_shared<LevelMarks>(static_cast<std::size_t>(values[0]));
  render::FrameStages stages;
  stages.reserve_surfaces = [marks](const render::FrameContext& context,
                                    const render::SurfaceRequests& requests, render::SurfaceCache& io_cache) {
    marks->begin_level(context.level());
    for (render::BlockRequest& request : requests.blocks) {
      if (!request.marks.empty()) continue;
      request.marks = marks->on_face(request.face);
      request.contents.marks = base::hash_with(base::to_size(request.face), 1);
    }
    return render::reserve_surfaces(context, requests, io_cache);
  };
  stages.build_surfaces = [marks](const render::FrameContext& context, const render::SurfaceBlocks& blocks,
                                  const render::MarkTables* /*mark_tables*/) {
    render::build_surfaces(context, blocks, &marks->tables(context.colors));
  };
  return stages;
}

}  // namespace temblor::lab
