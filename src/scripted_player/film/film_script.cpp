#include "scripted_player/film/film_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "base/text.h"
#include "base/words.h"

namespace temblor::player {
namespace {

// Before a place that is relative to the player.
constexpr std::string_view kRelative = "player+";

std::optional<math::Vec3> parse_place(std::string_view text) {
  math::Vec3 place(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = text.find(',');
    if ((comma == text.npos) != (axis == 2)) return std::nullopt;
    const std::optional<float> number = base::parse_number<float>(text.substr(0, comma));
    if (!number) return std::nullopt;
    place[axis] = *number;
    if (axis < 2) text.remove_prefix(comma + 1);
  }
  return place;
}

// Parses a script line by line.
class ScriptParser {
 public:
  base::Result<FilmScript> parse(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      const std::string_view line = text.substr(0, end);
      const auto words = base::split_words(line.substr(0, line.find('#')), " \t\r");
      if (!words.empty()) TRY_STATUS(add_line(words));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    TRY_STATUS(finish_scene());
    if (script_.scenes.empty()) return base::malformed("the film has no scene");
    return std::move(script_);
  }

 private:
  using Words = std::span<const std::string_view>;

  template <typename... Args>
  base::Error fail(fmt::format_string<Args...> format, Args&&... args) const {
    return base::malformed("line {}: {}", line_, fmt::format(format, std::forward<Args>(args)...));
  }

  base::Status add_line(Words words) {
    const std::string_view keyword = words[0];
    words = words.subspan(1);
    if (keyword == "film") return add_film(words);
    if (keyword == "scene") return add_scene(words);
    if (keyword == "eyes" || keyword == "camera") return add_shot(keyword == "camera", words);
    if (keyword == "title") return add_title(words);
    if (keyword == "at") return add_key(words);
    return fail("\"{}\" is not a keyword; expected film, scene, eyes, camera, title, or at",
                base::quotable(keyword));
  }

  base::Status add_film(Words words) {
    for (const std::string_view word : words) {
      const auto [name, value] = split_setting(word);
      if (name == "title")
        script_.title_model = value;
      else if (name != "track" || !read_number(value, script_.track))
        return fail("\"{}\" is not a setting of a film; expected track=N or title=MODEL",
                    base::quotable(word));
    }
    return base::Ok{};
  }

  base::Status add_scene(Words words) {
    TRY_STATUS(finish_scene());
    if (words.empty()) return fail("a scene needs the name of a level");
    FilmScene scene{.map = std::string(words[0]), .shots = {}};
    for (const std::string_view word : words.subspan(1)) {
      const auto [name, value] = split_setting(word);
      if (word == "god")
        scene.has_god = true;
      else if (word == "tour")
        scene.visits_stops = true;
      else if (!((name == "seed" && read_number(value, scene.seed)) ||
                 (name == "skill" && read_number(value, scene.skill) && scene.skill >= 0 &&
                  scene.skill <= 3) ||
                 (name == "bots" && read_number(value, scene.bots) && scene.bots <= 15)))
        return fail(
            "\"{}\" is not a setting of a scene; expected skill=0 to 3, seed=N, bots=0 to 15, god, or tour",
            base::quotable(word));
    }
    script_.scenes.push_back(std::move(scene));
    return base::Ok{};
  }

  base::Status add_shot(bool is_flight, Words words) {
    if (script_.scenes.empty()) return fail("a shot needs a scene above it");
    TRY_STATUS(finish_shot());
    std::vector<Shot>& shots = script_.scenes.back().shots;
    Shot shot;
    if (words.size() != 2 || !read_number(words[0], shot.begin_s) || !read_number(words[1], shot.end_s) ||
        shot.begin_s < 0 || shot.end_s <= shot.begin_s)
      return fail("a shot needs the times of its begin and its later end, in seconds");
    if (!shots.empty() && shot.begin_s < shots.back().end_s)
      return fail("the shot begins before the end of the one above it; sort the shots by time");
    if (!is_flight && !shots.empty() && is_flight_)
      return fail("the player's view cannot follow a camera flight; repeat the line of the scene above it");
    shots.push_back(shot);
    is_flight_ = is_flight;
    has_shot_ = true;
    return base::Ok{};
  }

  base::Status add_title(Words words) {
    if (!has_shot_ || !is_flight_) return fail("a title needs a camera above it");
    if (script_.title_model.empty()) return fail("a title needs a line \"film title=MODEL\" at the top");
    TitlePlace title;
    const std::optional<math::Vec3> place = words.empty() ? std::nullopt : parse_place(words[0]);
    if (!place || words.size() > 2) return fail("a title needs a place X,Y,Z and may have yaw=DEGREES");
    title.place_world = *place;
    if (words.size() == 2) {
      const auto [name, value] = split_setting(words[1]);
      if (name != "yaw" || !read_number(value, title.yaw_deg))
        return fail("\"{}\" is not a setting of a title; expected yaw=DEGREES", base::quotable(words[1]));
    }
    script_.scenes.back().shots.back().title = title;
    return base::Ok{};
  }

  base::Status add_key(Words words) {
    if (!has_shot_ || !is_flight_) return fail("a camera's place needs a camera above it");
    CameraKey key;
    std::optional<math::Vec3> place, target;
    if (words.size() == 3 && read_number(words[0], key.time_s)) {
      std::string_view text = words[1];
      key.is_relative = text.starts_with(kRelative);
      if (key.is_relative) text.remove_prefix(kRelative.size());
      place = parse_place(text);
      const auto [name, value] = split_setting(words[2]);
      const bool is_target = name == "look" && (value == "player" || (target = parse_place(value)));
      if (!is_target) place.reset();
    }
    if (!place)
      return fail(
          "a camera's place needs the form: at TIME X,Y,Z look=X,Y,Z (or player+X,Y,Z, and look=player)");
    std::vector<CameraKey>& keys = script_.scenes.back().shots.back().camera;
    if (!keys.empty() && key.time_s <= keys.back().time_s)
      return fail("the camera's places must be in order of time");
    key.place = *place;
    key.target_world = target;
    keys.push_back(key);
    return base::Ok{};
  }

  base::Status finish_shot() {
    if (has_shot_ && is_flight_ && script_.scenes.back().shots.back().camera.size() < 2)
      return fail("the camera above this line needs two places or more");
    return base::Ok{};
  }

  base::Status finish_scene() {
    TRY_STATUS(finish_shot());
    if (!script_.scenes.empty() && !has_shot_) return fail("the scene above this line has no shot");
    has_shot_ = is_flight_ = false;
    return base::Ok{};
  }

  static std::pair<std::string_view, std::string_view> split_setting(std::string_view word) {
    const std::size_t equals = word.find('=');
    if (equals == word.npos) return {};
    return {word.substr(0, equals), word.substr(equals + 1)};
  }

  template <typename Number>
  static bool read_number(std::string_view text, Number& out_number) {
    const std::optional<Number> number = base::parse_number<Number>(text);
    if (number) out_number = *number;
    return number.has_value();
  }

  FilmScript script_;
  int line_ = 0;
  // Whether the last scene has a shot yet, and whether that is a flight.
  bool has_shot_ = false, is_flight_ = false;
};

}  // namespace

base::Result<FilmScript> read_film_script(std::string_view text) {
  return ScriptParser().parse(text);
}

}  // namespace temblor::player
