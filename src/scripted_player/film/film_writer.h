// Joins parts of demos to one demo. Method: the messages of each record are read and written again. A record
// outside all shots keeps only messages with lasting effect, such as the level's beginning and light styles,
// and the times of later records are moved, so that no cut takes longer than a tick.
//
// In a flight, the view is an additional entity, which has a model, because clients do not move entities
// without one, but is not drawn, because clients do not draw the view entity. An empty svc_cutscene hides the
// status bar and the weapon until the next level.
#pragma once

#include <map>
#include <string>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/game/dem.h"
#include "scripted_player/film/camera_path.h"
#include "scripted_player/film/film_script.h"

namespace temblor::player {

// Poses of the camera by server time, which may differ from the demo's by less than half a tick.
using CameraPoses = std::map<float, CameraPose>;

class FilmWriter {
 public:
  explicit FilmWriter(const FilmScript& script) : script_(script) {}

  // Appends the shots of a scene of the script, from a demo of the whole scene. `poses` has those of the
  // records in flights.
  base::Status add(const FilmScene& scene, base::Bytes demo, const CameraPoses& poses);
  // Seconds of all shots so far.
  double length_s() const { return length_s_; }
  base::ByteVector finish() &&;

 private:
  const FilmScript& script_;
  formats::DemWriter writer_;
  double length_s_ = 0;
  bool has_scene_ = false;
};

}  // namespace temblor::player
