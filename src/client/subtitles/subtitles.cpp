#include "client/subtitles/subtitles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "client/hud/center_text.h"
#include "client/subtitles/stock_captions.h"
#include "math/angles.h"

namespace temblor::client {
namespace {

constexpr std::size_t kMaxLines = 4;
constexpr double kCaptionDuration_s = 2;
// Units, divided by the sound's attenuation: the distance at which the mixer's volume reaches 0.
constexpr float kSilentDistance_units = 1000;
// Gap above the status bar, in the original's pixels.
constexpr int kAboveBar = 8;

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

// The words of a file's name, without digits.
std::string name_sound(std::string_view file) {
  file = file.substr(0, file.rfind('.'));
  std::string words;
  for (const char c : file.substr(0, formats::kMaxCaptionChars)) {
    if (c >= 'a' && c <= 'z')
      words += c;
    else if (!words.empty() && words.back() != ' ')
      words += ' ';
  }
  while (words.ends_with(' ')) words.pop_back();
  return words;
}

}  // namespace

std::string make_caption(const formats::Captions& captions, std::string_view sound) {
  const std::string file = base::to_lower(sound);
  if (const auto own = captions.texts.find(file); own != captions.texts.end()) return own->second;
  if (const std::optional<std::string_view> stock = find_stock_caption(file)) return std::string(*stock);
  return name_sound(file);
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
    std::string caption = make_caption(captions_, game.sounds[sound.sound]);
    if (side == SoundSide::kSeen || caption.empty()) continue;
    std::erase_if(lines_, [&](const Line& line) { return line.caption == caption && line.side == side; });
    lines_.push_back({std::move(caption), side, time_s});
  }
  if (lines_.size() > kMaxLines) lines_.erase(lines_.begin(), lines_.end() - kMaxLines);
}

void Subtitles::draw(const assets::Pictures& pictures, int width, int height, HudSize size, int covered_px,
                     render::DrawList& io_list) const {
  const Panel panel(pictures, io_list, width, height, choose_scale(width, height, size));
  const Panel letters = panel.with_scale(choose_text_scale(width, height, size));
  constexpr int kPadding = 2;
  // From the newest caption upward.
  const int bars_px = (kBarHeight + kInventoryHeight) * panel.scale();
  int top_px = height - std::max(bars_px, covered_px) - kAboveBar * panel.scale();
  for (auto line = lines_.rbegin(); line != lines_.rend(); ++line) {
    const std::string text = format_caption(line->caption, line->side);
    const int rows = count_text_lines(letters, text);
    top_px -= rows * kTextLine * letters.scale();
    const Panel place = letters.with_top(top_px);
    // A dark background keeps it readable.
    const int columns = std::min(static_cast<int>(text.size()), width / (letters.scale() * kCharacterSide));
    const int text_width = columns * kCharacterSide;
    place.fill((kScreenWidth - text_width) / 2 - kPadding, -1, text_width + 2 * kPadding, rows * kTextLine, 0,
               0.5f);
    draw_text_lines(place, text, kTextLine);
  }
}

}  // namespace temblor::client
