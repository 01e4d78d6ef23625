// A model as its script describes it, and the two steps that make an alias model (MDL) from it.
//
//   model lines --read_model--> Model --make_mdl--> formats::Mdl
//                  bones, mesh (rings.h, solids.h),     poses as bytes, texel coordinates (atlas.h),
//                  paints, animations                   skins (skin.h)
//
// x is forward, y left, z up, in map units, with the entity's origin at 0. docs/art-scripts.md describes the
// keywords.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "artgen/art.h"
#include "artgen/models/animation.h"
#include "artgen/models/mesh.h"
#include "artgen/models/skeleton.h"
#include "artgen/models/skin.h"
#include "artgen/scripts/script.h"
#include "base/result.h"
#include "formats/models/mdl.h"

namespace temblor::artgen {

// Everything that a model's script says.
struct Model {
  std::string path;
  // Texels per unit on the skin.
  double density = 2;
  // The height of the floor, for animations that settle and for `size`.
  double floor = -24;
  // Scales the model around the middle of the floor. The speed of gaits stays the same.
  double size = 1;
  // The eye position in the MDL header.
  math::Vec3 eye{0.0f};
  std::uint32_t flags = 0;  // formats::MdlFlags
  // Frame groups start at a random time, so that several torches do not flicker in step.
  bool random_phase = false;
  Skeleton skeleton;
  Mesh mesh;
  // By shape number.
  std::vector<ShapeLook> shapes;
  // The paints of each skin; shapes refer to them by index. The first skin has the model's own paints.
  std::vector<std::vector<Paint>> skins;
  // By name. "stance" is the base of all animations.
  std::map<std::string, ChannelValues> poses;
  // At least one.
  std::vector<Animation> animations;
};

// Reads a `model` line and everything under it. The order of the lines does not matter, except within one
// kind. Errors begin with the line's number.
base::Result<Model> read_model(const ScriptLine& asset);

// Poses every frame, packs the skin, and paints it. Deterministic.
formats::Mdl make_mdl(const Model& model);

// The ArtMaker of `model`.
base::Result<std::vector<ArtPart>> make_model_art(const ScriptLine& asset);

}  // namespace temblor::artgen
