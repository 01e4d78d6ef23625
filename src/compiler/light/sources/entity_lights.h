// Reads the lights among a level's entities.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/light/sources/light_source.h"
#include "compiler/light/sources/settings.h"
#include "compiler/report.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// A light with _surface: a copy of it is placed on every face with a texture.
struct SurfaceTemplate {
  std::string texture;
  float offset = 2;        // units in front of the face
  bool spotlight = false;  // shines along the face's normal
  LightSource light;       // without an origin, and without a spotlight's direction
};

// The lights of a level, except suns.
struct EntityLights {
  std::vector<LightSource> lights;
  std::vector<SurfaceTemplate> templates;
};

// Gives every light with a targetname the style that belongs to the name: 32 and up, in the order in which
// names first appear. Returns whether an entity changed. Names beyond the 32nd keep their style, with a
// warning.
bool assign_switchable_styles(std::vector<formats::Entity>& io_entities, Warnings& io_warnings);

// Whether an entity is a light of any kind.
bool is_light(const formats::Entity& entity);

// Reads all lights except suns (sky_lights.h). Warns about lights that cannot be read.
EntityLights find_entity_lights(std::span<const formats::Entity> entities, const LightSettings& settings,
                                Warnings& io_warnings);

}  // namespace temblor::compiler
