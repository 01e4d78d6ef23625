// The parts that techniques for small triangles share. Models are prepared with corners at whole pixels and
// affine texels, and their front triangles are sorted by size. Large ones are drawn by the engine's scan
// lines, and small ones by the technique.
#pragma once

#include <memory>

#include "lab/models/small/small_masks.h"
#include "lab/models/small/small_pixels.h"
#include "lab/technique.h"

namespace temblor::lab {

// A small front triangle in whole pixels.
struct SmallTriangle {
  std::uint32_t number;
  std::int32_t left, top;      // of its box
  std::uint8_t width, height;  // at most SmallMasks::kMaxSide
  std::uint16_t corners;       // SmallMasks::number(), by which its mask is found
};

// Where small triangles of one model are drawn.
template <typename Pixel>
class SmallPainter {
 public:
  SmallPainter(const render::TriangleJob& job, const render::TriangleTarget& target);

  bool has_rows(const SmallTriangle& triangle) const {
    return triangle.top < target_.row_end && triangle.top + triangle.height > target_.row_begin;
  }
  bool has_all_pixels(const SmallTriangle& triangle) const {
    return triangle.left >= 0 && triangle.left + triangle.width <= target_.width &&
           triangle.top >= target_.row_begin && triangle.top + triangle.height <= target_.row_end;
  }
  // The triangle from its pixel at a column and a row of its box. The pixel must be in the target.
  const SmallDrawing& start(const SmallTriangle& triangle, std::int32_t column, std::int32_t row);
  // Draws those of a triangle's pixels that are in the target. `mask` must not be 0.
  void draw_mask(const SmallTriangle& triangle, std::uint32_t mask);

 private:
  struct Corner {
    float x, y;
  };
  // Returns corner a, from the top left of the box.
  Corner set_values(const SmallTriangle& triangle);
  std::uint32_t clip_mask(const SmallTriangle& triangle, std::uint32_t mask) const;

  const render::TriangleJob& job_;
  const render::TriangleTarget& target_;
  SmallDrawing drawing_;
};

// Draws small triangles of one model. Several bands may call it at once.
class SmallTriangleCode {
 public:
  virtual ~SmallTriangleCode() = default;
  virtual void draw(const render::TriangleJob& job, std::span<const SmallTriangle> triangles,
                    render::PixelFormat format, const render::TriangleTarget& target) const = 0;
  virtual std::size_t size_bytes() const = 0;
};

// Triangles up to `side` pixels wide and high are small.
render::FrameStages make_small_triangle_stages(std::int32_t side,
                                               std::shared_ptr<const SmallTriangleCode> code,
                                               Counter* counter);

}  // namespace temblor::lab
