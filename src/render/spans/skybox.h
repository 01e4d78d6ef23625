// A skybox prepared for drawing: six squares of the same size in the frame's pixel format, each (size + 2) x
// (size + 2) texels. The border of one texel holds the neighbors' texels, so that interpolation shows no
// seams. Stock Quake has no skyboxes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/color/color_tables.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/spans/skybox_kernels.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Larger pictures are scaled down to this. Pictures of other sizes than the largest are scaled to its size.
constexpr std::int32_t kMaxSkyboxTexels = 2048;

class PreparedSkybox {
 public:
  // Prepares the skybox unless it is the one that was prepared last, in the same format and with the same
  // color for empty sides. `fog` colors sides without a picture.
  void update(const Skybox& skybox, const Fog& fog, const ColorTables& tables, PixelFormat format);

  // The kernel input for the prepared skybox; the caller fills in depth and spans.
  SkyboxSpans spans(const ViewFrame& view) const;
  // Counts the skyboxes that were prepared, so that copies of the texels know whether they are old.
  std::uint64_t version() const { return version_; }

 private:
  struct Made {
    std::shared_ptr<const SkyboxIdentity> identity;
    PixelFormat format;
    std::uint32_t empty_rgb;
    bool operator==(const Made&) const = default;
  };
  Made made_{};
  std::uint64_t version_ = 0;
  std::int32_t size_ = 0;
  std::vector<std::uint32_t> rgb_;
  std::vector<std::uint8_t> indexed_;
};

}  // namespace temblor::render
