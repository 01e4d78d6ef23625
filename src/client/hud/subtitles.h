// Sounds that come from where the player does not look, in words, for who does not hear them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "assets/pictures.h"
#include "client/session/client_state.h"
#include "render/draw_list.h"
#include "render/scene.h"

namespace temblor::client {

// The name of a sound's file as words: "soldier/sight1.wav" is "soldier sight", "doors/drclos4.wav" "doors
// drclos".
std::string caption_of(std::string_view sound);

enum class SoundSide { kSeen, kLeft, kRight, kBehind };
// Where a place is to who looks through `camera`: within its field of view, or where to turn.
SoundSide side_of(const math::Vec3& place_world, const render::Camera& camera);

class Subtitles {
 public:
  void begin_level() { lines_.clear(); }
  // What has sounded near enough to be heard, by others than the player himself. Time that runs backwards
  // ends what is shown.
  void advance(const Game& game, const Events& events, const render::Camera& camera, double time_s);
  // In the lower middle of a frame of that size, the newest lowest. Valid while the pictures live.
  void draw(const assets::Pictures& pictures, int width, int height, int scale,
            render::DrawList& io_list) const;

 private:
  struct Line {
    std::string caption;
    SoundSide side;
    double since_s;
  };
  std::vector<Line> lines_;
};

}  // namespace temblor::client
