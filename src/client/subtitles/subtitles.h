// Captions for sounds from outside the view, for players who cannot hear them. Stock Quake has none. Arrows
// show which way to turn.
//
//   captions.txt of the game, or else the stock sounds' captions, or else the words of the file's name
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/pictures.h"
#include "client/hud/panel.h"
#include "client/session/client_state.h"
#include "formats/game/captions.h"
#include "render/draw_list.h"
#include "render/scene.h"

namespace temblor::client {

// The caption of a sound, "dog/dattack1.wav"; empty for silence. A sound that neither the game nor stock
// Quake has is called by the words of its name: "gug/roar2.wav" becomes "gug roar".
std::string make_caption(const formats::Captions& captions, std::string_view sound);

// Where a sound comes from, relative to the view.
enum class SoundSide { kSeen, kLeft, kRight, kBehind };
// Whether a place is within the camera's horizontal field of view, or else where it is: in the quarter behind
// the player, or to the left or right.
SoundSide find_sound_side(const math::Vec3& place_world, const render::Camera& camera);

class Subtitles {
 public:
  explicit Subtitles(formats::Captions captions) : captions_(std::move(captions)) {}

  void begin_level() { lines_.clear(); }
  // Adds captions for audible sounds from outside the view that the player did not make, and removes captions
  // after two seconds. If time runs backward, removes all captions.
  void advance(const Game& game, const Events& events, const render::Camera& camera, double time_s);
  // Draws the captions in the lower middle of a frame of `width` x `height` pixels, the newest at the bottom,
  // above the status bar and the `covered_px` at the frame's bottom. The commands are valid while the
  // pictures live.
  void draw(const assets::Pictures& pictures, int width, int height, HudSize size, int covered_px,
            render::DrawList& io_list) const;

 private:
  struct Line {
    std::string caption;
    SoundSide side;
    // When the sound started, server time.
    double since_s;
  };
  formats::Captions captions_;
  std::vector<Line> lines_;
};

}  // namespace temblor::client
