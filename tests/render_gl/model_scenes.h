// Scenes with alias models, and the comparison of their pictures with the CPU's.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "render_gl/gl_pictures.h"
#include "support/pictures/viewpoints.h"
#include "support/random.h"

namespace temblor::render_gl {

using ModelPtr = std::shared_ptr<const render::AliasModel>;

// A view of a level, with the models that it refers to.
struct ModelScene {
  std::vector<ModelPtr> models;
  std::vector<render::AliasInstance> instances = {};
  std::optional<render::AliasInstance> weapon = {};
  test::Viewpoint viewpoint = {};
  render::Fog fog = {};
  render::LiquidAlpha liquid_alpha = {};

  // Valid as long as this object and the level.
  render::Scene scene(const world::Level& level) const;
};

// Models made in code, with three skins of squares of 8 x 8 texels: a box, a sphere, and one with several
// poses.
// The CPU maps texels affinely where that is off by at most half a texel, so only the squares' borders may
// differ. Some squares are full-bright.
std::vector<ModelPtr> make_small_models();
// The same as MD3 files, whose poses have 16 bits.
std::vector<ModelPtr> make_wide_models();
// An MDL file of the game. CHECKs that it can be read.
ModelPtr load_model(const std::filesystem::path& path);
// A box with this many skins.
ModelPtr make_box_with_skins(std::size_t count);

// An instance of a random model at about `distance` in front of the camera, in any pose, with any skin, and
// at any angles. All of it is farther than distance / 2 - 52 * scale units.
render::AliasInstance random_instance(const ModelScene& scene, double distance, test::Random& io_random);

// A random view of the level with `count` instances before the camera.
ModelScene random_scene(std::vector<ModelPtr> models, const world::Level& level, int count,
                        test::Random& io_random);

// The shares of pixels that agree.
struct ModelShares {
  double whole = 1;  // of all pixels, those within 2 of 255
  double own = 1;    // of the pixels that the models change on the CPU, those within 8 of 255
  std::size_t own_pixels = 0;
};

// Draws the scene with and without its models.
ModelShares compare_models(RendererPair& io_pair, const ModelScene& scene, const world::Level& level,
                           const render::Settings& settings = {});

}  // namespace temblor::render_gl
