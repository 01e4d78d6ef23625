// Captions for sounds from outside the view, for players who cannot hear them. Stock Quake has none. A
// caption is made from the sound's file name, so it works for any game; arrows show which way to turn.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assets/pictures.h"
#include "client/session/client_state.h"
#include "render/draw_list.h"
#include "render/scene.h"

namespace temblor::client {

// A caption from a sound's file name: "soldier/sight1.wav" becomes "soldier sight", "doors/drclos4.wav"
// "doors drclos".
std::string make_caption(std::string_view sound);

// Where a sound comes from, relative to the view.
enum class SoundSide { kSeen, kLeft, kRight, kBehind };
// Whether a place is within the camera's horizontal field of view, or else where it is: in the quarter behind
// the player, or to the left or right.
SoundSide find_sound_side(const math::Vec3& place_world, const render::Camera& camera);

class Subtitles {
 public:
  void begin_level() { lines_.clear(); }
  // Adds captions for audible sounds from outside the view that the player did not make, and removes captions
  // after two seconds. If time runs backward, removes all captions.
  void advance(const Game& game, const Events& events, const render::Camera& camera, double time_s);
  // Draws the captions in the lower middle of a frame of `width` x `height` pixels, the newest at the bottom.
  // The commands are valid while the pictures live. `scale`: see choose_scale().
  void draw(const assets::Pictures& pictures, int width, int height, int scale,
            render::DrawList& io_list) const;

 private:
  struct Line {
    std::string caption;
    SoundSide side;
    // When the sound started, server time.
    double since_s;
  };
  std::vector<Line> lines_;
};

}  // namespace temblor::client
