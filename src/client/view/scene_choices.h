// Choices of parts of the scene, and of the place that it is seen from. Mappers look into their levels with
// them, and players hold what flickers steady. The names are those of other engines.
#pragma once

#include <optional>

#include "client/view/view.h"
#include "command/variables.h"
#include "render/scene.h"
#include "world/level.h"

namespace temblor::client {

// A camera behind the player: chase_active, chase_back, chase_up, chase_right. In units.
struct ChaseCamera {
  float back = 100, up = 16, right = 0;
};

struct SceneChoices {
  bool entities = true, particles = true, dynamic_lights = true;
  // False: the view is not warped under water.
  bool warps_underwater = true;
  // Draws MD5 models instead of the MDL files that they replace.
  bool md5_models = true;
  // Shows the boxes of entities; the caller supplies them (PresentationSettings::boxes).
  bool boxes = false;
  // Draws what was visible when this became true, wherever the eye goes.
  bool locks_pvs = false;
  world::LightStyleMode light_styles = world::LightStyleMode::kFlickering;
  std::optional<ChaseCamera> chase;
};

class SceneChoiceVariables {
 public:
  explicit SceneChoiceVariables(command::Variables& variables);
  SceneChoices read(const command::Variables& variables) const;

 private:
  command::VariableIndex entities_, particles_, dynamic_lights_, water_warp_, md5_models_, lock_pvs_, boxes_,
      flat_light_styles_, chase_active_, chase_back_, chase_up_, chase_right_;
};

// Moves the view's camera behind the player, in front of any wall there, and turns it to what the player
// looks at.
void chase_player(const world::Level& level, const ChaseCamera& chase, PlayerView& io_view);

// Removes what is not wanted from a finished scene.
void apply_choices(const SceneChoices& choices, render::Scene& io_scene);

}  // namespace temblor::client
