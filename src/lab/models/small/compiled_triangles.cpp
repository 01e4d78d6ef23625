// Hot loop: one triangle at a time, with a call of its shape's code.
#include "lab/models/small/compiled_triangles.h"

#include <memory>
#include <optional>
#include <utility>

#include "lab/models/small/assembled_shapes.h"
#include "lab/models/small/built_shapes.h"
#include "lab/models/small/small_shapes.h"
#include "lab/models/small/small_triangles.h"

namespace temblor::lab {

namespace {

class CompiledCode : public SmallTriangleCode {
 public:
  // Without `assembled`, the code of the build is used.
  explicit CompiledCode(std::optional<AssembledShapes> assembled) : assembled_(std::move(assembled)) {}

  void draw(const render::TriangleJob& job, std::span<const SmallTriangle> triangles,
            render::PixelFormat format, const render::TriangleTarget& target) const override {
    const bool is_indexed = format == render::PixelFormat::kIndexed;
    const std::span<const DrawShape> code = is_indexed ? indexed(job) : rgb(job);
    is_indexed ? draw<std::uint8_t>(code, job, triangles, target)
               : draw<std::uint32_t>(code, job, triangles, target);
  }
  std::size_t size_bytes() const override {
    return shapes_.size_bytes() + masks_.size_bytes() + (assembled_ ? assembled_->size_bytes() : 0);
  }

 private:
  bool is_assembled_for(const render::TriangleJob& job) const {
    return assembled_ && job.skin_width <= AssembledShapes::kMaxSkinSide &&
           job.skin_height <= AssembledShapes::kMaxSkinSide;
  }
  std::span<const DrawShape> indexed(const render::TriangleJob& job) const {
    return is_assembled_for(job) ? assembled_->indexed() : list_built_shapes().indexed;
  }
  std::span<const DrawShape> rgb(const render::TriangleJob& job) const {
    return is_assembled_for(job) ? assembled_->rgb() : list_built_shapes().rgb;
  }

  template <typename Pixel>
  void draw(std::span<const DrawShape> code, const render::TriangleJob& job,
            std::span<const SmallTriangle> triangles, const render::TriangleTarget& target) const {
    SmallPainter<Pixel> painter(job, target);
    for (const SmallTriangle& triangle : triangles) {
      if (!painter.has_rows(triangle)) continue;
      const PlacedShape shape = shapes_.find(triangle.corners);
      if (shape.number == kNoShape) continue;
      if (painter.has_all_pixels(triangle))
        code[shape.number](painter.start(triangle, shape.column, shape.row));
      else
        painter.draw_mask(triangle, masks_.find(triangle.corners));
    }
  }

  SmallMasks masks_;
  SmallShapes shapes_{masks_};
  std::optional<AssembledShapes> assembled_;
};

base::Result<std::optional<AssembledShapes>> assemble(std::span<const double> values) {
  if (values[1] == 0) return std::optional<AssembledShapes>();
  TRY(AssembledShapes assembled, AssembledShapes::make(list_built_shapes().masks));
  return std::optional<AssembledShapes>(std::move(assembled));
}

}  // namespace

render::FrameStages make_compiled_triangles(std::span<const double> values, Counter* counter) {
  base::Result<std::optional<AssembledShapes>> assembled = assemble(values);
  if (!assembled.ok()) return {};
  return make_small_triangle_stages(static_cast<std::int32_t>(values[0]),
                                    std::make_shared<CompiledCode>(std::move(assembled.value())), counter);
}

base::Status check_compiled_triangles(std::span<const double> values, const world::Level& /*level*/) {
  TRY_STATUS(assemble(values));
  return base::Ok{};
}

}  // namespace temblor::lab
