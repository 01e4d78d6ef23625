// Textures of the shipped game: each a lump of textures.wad, with its mip levels.
//
//   texture NAME WxH               one texture
//   animation NAME WxH frames=4    +0NAME, +1NAME ...
//   switch NAME WxH                +0NAME and +aNAME, before and after it is pressed; frames=2 gives each two
//
// In an animation or a switch, a value with slashes is another one in each frame: at=8,8/8,16/8,24. A name
// that begins with { has holes where nothing is painted.
#pragma once

#include <vector>

#include "artgen/art.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen {

base::Result<std::vector<ArtPart>> make_texture(const ScriptLine& thing);
base::Result<std::vector<ArtPart>> make_animation(const ScriptLine& thing);
base::Result<std::vector<ArtPart>> make_switch(const ScriptLine& thing);

}  // namespace temblor::artgen
