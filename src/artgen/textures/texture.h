// Makes the textures of the shipped game: lumps of textures.wad with four mip levels.
//
//   texture NAME WxH               one texture
//   animation NAME WxH frames=4    +0NAME, +1NAME, and so on
//   switch NAME WxH                +0NAME and +aNAME: released and pressed; frames=2 makes two of each
//
// In animations and switches, slashes separate the values of the frames: at=8,8/8,16/8,24. If a name begins
// with "{", unpainted texels are transparent. The lines under a texture are its layers (layer.h), painted in
// their order.
#pragma once

#include <vector>

#include "artgen/art.h"
#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen {

// ArtMakers; see art.h.
base::Result<std::vector<ArtPart>> make_texture(const ScriptLine& asset);
base::Result<std::vector<ArtPart>> make_animation(const ScriptLine& asset);
base::Result<std::vector<ArtPart>> make_switch(const ScriptLine& asset);

}  // namespace temblor::artgen
