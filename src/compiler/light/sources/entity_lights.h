// Reads the lights among a level's entities.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compiler/light/sources/light_source.h"
#include "compiler/light/sources/projection.h"
#include "compiler/light/sources/settings.h"
#include "compiler/report.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// A light with _surface: a copy of it is placed on every face with a texture.
struct SurfaceTemplate {
  std::string texture;
  float offset = 2;          // units in front of the face
  bool spotlight = false;    // shines along the face's normal
  std::int32_t group = 0;    // shines only from brushes with this _surflight_group
  std::int8_t rescale = -1;  // _surflight_rescale, or -1 without: equally bright in all directions
  LightSource light;         // without an origin, and without a spotlight's direction
};

// The lights of a level, except suns.
struct EntityLights {
  std::vector<LightSource> lights;
  std::vector<SurfaceTemplate> templates;
  std::vector<Projection> projections;  // by LightSource::projection; without texels
};

// Whether an entity is a light of any kind.
bool is_light(const formats::Entity& entity);

// Names a light by its origin: numbers of entities in the level differ from those in the map, which has
// groups and details.
std::string describe_light(const formats::Entity& entity);

// Reads all lights except suns (sky_lights.h). Warns about lights that cannot be read.
EntityLights find_entity_lights(std::span<const formats::Entity> entities, const LightSettings& settings,
                                Warnings& io_warnings);

}  // namespace temblor::compiler
