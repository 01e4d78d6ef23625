// A model as its script has it: bones, shapes on them, paints and movement; and what becomes of it.
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

struct Model {
  std::string path;
  double density = 2;  // texels a unit
  double floor = -24;  // where what settles lies
  double size = 1;     // everything grows from the middle of the floor; gaits keep their speed
  math::Vec3 eye{0.0f};
  std::uint32_t flags = 0;  // formats::MdlFlags
  bool random_phase = false;
  Skeleton skeleton;
  Mesh mesh;
  std::vector<ShapeLook> shapes;
  std::vector<std::vector<Paint>> skins;  // every skin's paints; the first is the model's own
  std::map<std::string, ChannelValues> poses;
  std::vector<Animation> animations;  // at least one
};

// Errors begin with the line. docs/art.md has the words.
base::Result<Model> read_model(const ScriptLine& thing);

formats::Mdl make_mdl(const Model& model);

// The maker of "model".
base::Result<std::vector<ArtPart>> make_model_art(const ScriptLine& thing);

}  // namespace temblor::artgen
