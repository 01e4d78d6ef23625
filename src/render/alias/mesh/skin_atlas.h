// Joins the skins of a model's meshes to one picture, one below the other, because a model is drawn from one
// picture. A skin whose texels lie outside of 0 to 1 repeats: it is stored as often as the mesh needs it.
//
//   mesh 0   +----+----+      skin 0, twice from left to right
//   mesh 1   +--+--+---+      skin 1; the rest of its rows is unused
//            +--+
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "formats/models/posed_model.h"
#include "render/alias/triangle_kernels.h"

namespace temblor::render {

// Limits of the joined picture, in texels. Texels in 1/65536 must fit 32 bits, and a small file must not ask
// for a large picture.
constexpr std::uint32_t kMaxAtlasSide = 1 << 14;
constexpr std::uint64_t kMaxAtlasTexels = 1 << 25;

// Where the skin of a mesh is.
struct AtlasPart {
  std::uint32_t width = 0, height = 0;    // of the skin, once
  std::int32_t first_s = 0, first_t = 0;  // the least whole number of skins to the left of and above a texel
  std::uint32_t columns = 1, rows = 1;    // repetitions
  std::uint32_t top = 0;                  // first row in the joined picture
};

struct SkinAtlas {
  std::uint32_t width = 0, height = 0;
  std::vector<AtlasPart> parts;  // by mesh
};

// `pictures`: the first skin of each mesh, which decides the sizes. Fails if the joined picture is too large.
base::Result<SkinAtlas> make_skin_atlas(const std::vector<formats::PosedMesh>& meshes,
                                        const std::vector<formats::Picture>& pictures);

// Returns the texels of the mesh's vertices in the joined picture, inside of its part.
std::vector<TexelPoint> place_texels(const AtlasPart& part, const std::vector<math::Vec2>& texels);

// Returns the joined picture. Pictures of other sizes than the first skin's are resampled.
std::vector<std::uint8_t> join_pictures(const SkinAtlas& atlas,
                                        const std::vector<formats::Picture>& pictures);

}  // namespace temblor::render
