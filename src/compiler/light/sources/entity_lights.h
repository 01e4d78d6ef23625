// The lights among a level's entities.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/light/sources/light_source.h"
#include "compiler/light/sources/settings.h"
#include "compiler/report.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// A light that stands on every face with a texture.
struct SurfaceTemplate {
  std::string texture;
  float offset = 2;        // units before the face
  bool spotlight = false;  // shines along the face's normal
  LightSource light;       // origin and a spotlight's direction are to be filled in
};

struct EntityLights {
  std::vector<LightSource> lights;
  std::vector<SurfaceTemplate> templates;
};

// Gives every light with a targetname the style of its name: from 32 on, in the order in which names come
// first. True when any entity changed. Names past the 32nd keep no style of their own (a warning).
bool assign_switchable_styles(std::vector<formats::Entity>& io_entities, Warnings& io_warnings);

// Whether an entity is a light of any kind.
bool is_light(const formats::Entity& entity);

// All lights but suns (sky_lights.h).
EntityLights entity_lights_of(std::span<const formats::Entity> entities, const LightSettings& settings,
                              Warnings& io_warnings);

}  // namespace temblor::compiler
