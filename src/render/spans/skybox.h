// A skybox ready to be drawn: six squares of one size in the frame's pixel format, each with a border of its
// neighbors' texels, so that nothing shows where sides meet.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/color/color_tables.h"
#include "render/frame.h"
#include "render/scene.h"
#include "render/spans/skybox_kernels.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Larger pictures are made smaller; ones of other shapes and sizes than the largest are stretched to it.
constexpr std::int32_t kMaxSkyboxTexels = 2048;

class PreparedSkybox {
 public:
  // Makes it ready, unless it was the last one. `fog` colors sides without a picture.
  void follow(const Skybox& skybox, const Fog& fog, const ColorTables& tables, PixelFormat format);

  // Of the last one; depth and runs are to be filled in.
  SkyboxRuns runs(const ViewFrame& view) const;

 private:
  struct Made {
    std::shared_ptr<const SkyboxIdentity> identity;
    PixelFormat format;
    std::uint32_t empty_rgb;
    bool operator==(const Made&) const = default;
  };
  Made made_{};
  std::int32_t size_ = 0;
  std::vector<std::uint32_t> rgb_;
  std::vector<std::uint8_t> indexed_;
};

}  // namespace temblor::render
