#include "client/hud/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/hud/panel.h"
#include "math/angles.h"

namespace temblor::client {
namespace {

constexpr std::size_t kMaxLines = 4;
constexpr double kCaptionDuration_s = 2;
// Units, divided by the sound's attenuation: the distance at which the mixer's volume reaches 0.
constexpr float kSilentDistance_units = 1000;
// Gap above the status bar, in the original's pixels.
constexpr int kAboveBar = 8;
constexpr std::size_t kMaxChars = 32;

// Whether the player could hear the sound. Attenuation 0 is heard everywhere.
bool is_audible(const net::Sound& sound, const render::Camera& camera) {
  return glm::distance(sound.origin, camera.origin_world) * sound.attenuation < kSilentDistance_units &&
         sound.volume > 0;
}

// Adds arrows: "< door", "door >", or "v door v" for a sound from behind.
std::string format_caption(const std::string& caption, SoundSide side) {
  switch (side) {
    case SoundSide::kLeft:
      return fmt::format("< {}", caption);
    case SoundSide::kRight:
      return fmt::format("{} >", caption);
    default:
      return fmt::format("v {} v", caption);
  }
}

}  // namespace

std::string make_caption(std::string_view sound) {
  if (const std::size_t dot = sound.rfind('.'); dot != std::string_view::npos) sound = sound.substr(0, dot);
  std::string words;
  for (const char c : sound.substr(0, kMaxChars)) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (is_letter)
      words += c;
    else if (!words.empty() && words.back() != ' ')
      words += ' ';
  }
  while (words.ends_with(' ')) words.pop_back();
  return words;
}

SoundSide find_sound_side(const math::Vec3& place_world, const render::Camera& camera) {
  const math::Basis basis = math::basis_from_angles(camera.angles_deg);
  const math::Vec3d direction = math::Vec3d(place_world) - math::Vec3d(camera.origin_world);
  const double ahead = glm::dot(direction, basis.forward), right = glm::dot(direction, basis.right);
  const double half_width = std::tan(static_cast<double>(camera.fov_deg) / 360 * 3.14159265358979);
  if (ahead > 0 && std::abs(right) <= ahead * half_width) return SoundSide::kSeen;
  if (ahead < 0 && std::abs(right) < -ahead) return SoundSide::kBehind;
  return right > 0 ? SoundSide::kRight : SoundSide::kLeft;
}

void Subtitles::advance(const Game& game, const Events& events, const render::Camera& camera, double time_s) {
  std::erase_if(lines_, [&](const Line& line) {
    return time_s < line.since_s || time_s - line.since_s > kCaptionDuration_s;
  });
  for (const net::Sound& sound : events.sounds) {
    if (sound.entity == game.view_entity || sound.sound >= game.sounds.size() || !is_audible(sound, camera))
      continue;
    // A sound that repeats renews its caption instead of filling the list.
    const SoundSide side = find_sound_side(sound.origin, camera);
    std::string caption = make_caption(game.sounds[sound.sound]);
    if (side == SoundSide::kSeen || caption.empty()) continue;
    std::erase_if(lines_, [&](const Line& line) { return line.caption == caption && line.side == side; });
    lines_.push_back({std::move(caption), side, time_s});
  }
  if (lines_.size() > kMaxLines) lines_.erase(lines_.begin(), lines_.end() - kMaxLines);
}

void Subtitles::draw(const assets::Pictures& pictures, int width, int height, int scale,
                     render::DrawList& io_list) const {
  const Panel panel(pictures, io_list, width, height, choose_scale(width, height, scale));
  const int rows = static_cast<int>(lines_.size());
  const Panel place = panel.at_bottom(kBarHeight + kInventoryHeight + kAboveBar + rows * kCharacterSide);
  for (int row = 0; row < rows; ++row) {
    const Line& line = lines_[static_cast<std::size_t>(row)];
    const std::string text = format_caption(line.caption, line.side);
    const int text_width = static_cast<int>(text.size()) * kCharacterSide;
    const int x = (kScreenWidth - text_width) / 2;
    // A dark background keeps it readable.
    place.fill(x - 2, row * kCharacterSide, text_width + 4, kCharacterSide, 0, 0.5f);
    place.draw_text(text, x, row * kCharacterSide);
  }
}

}  // namespace temblor::client
