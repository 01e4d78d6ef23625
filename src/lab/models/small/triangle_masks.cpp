// Hot loop: one triangle at a time, with the four values of a pixel as one vector. Most of these triangles
// have a few pixels.
#include "lab/models/small/triangle_masks.h"

#include <memory>

#include "lab/models/small/small_triangles.h"

namespace temblor::lab {

namespace {

class MaskCode : public SmallTriangleCode {
 public:
  void draw(const render::TriangleJob& job, std::span<const SmallTriangle> triangles,
            render::PixelFormat format, const render::TriangleTarget& target) const override {
    format == render::PixelFormat::kIndexed ? draw<std::uint8_t>(job, triangles, target)
                                            : draw<std::uint32_t>(job, triangles, target);
  }
  std::size_t size_bytes() const override { return masks_.size_bytes(); }

 private:
  template <typename Pixel>
  void draw(const render::TriangleJob& job, std::span<const SmallTriangle> triangles,
            const render::TriangleTarget& target) const {
    SmallPainter<Pixel> painter(job, target);
    for (const SmallTriangle& triangle : triangles) {
      if (!painter.has_rows(triangle)) continue;
      const std::uint32_t mask = masks_.find(triangle.corners);
      if (mask != 0) painter.draw_mask(triangle, mask);
    }
  }

  SmallMasks masks_;
};

}  // namespace

render::FrameStages make_triangle_masks(std::span<const double> values, Counter* counter) {
  return make_small_triangle_stages(static_cast<std::int32_t>(values[0]), std::make_shared<MaskCode>(),
                                    counter);
}

}  // namespace temblor::lab
