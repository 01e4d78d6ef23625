#include "app/lab/book/chapters.h"

#include <fmt/format.h>

#include <array>

namespace temblor::app {

std::string describe_time(const Evidence& evidence) {
  return fmt::format("A frame takes {} times the engine's.", evidence.time_ratios().text(2));
}

std::string describe_wrong(const Evidence& evidence) {
  const Range wrong = evidence.wrong_shares();
  if (wrong.high == 0) return "No pixel shows a wrong face.";
  return fmt::format("Wrong faces: {} % of pixels.", Range{100 * wrong.low, 100 * wrong.high}.text(3));
}

Verdict judge_slower(const Evidence& evidence) {
  const Range times = evidence.time_ratios();
  return {times.low > kSameTime    ? Holds::kYes
          : times.high > kSameTime ? Holds::kPartly
                                   : Holds::kNo,
          describe_time(evidence) + " " + describe_wrong(evidence)};
}

std::span<const BookChapter> list_book_chapters() {
  static const std::array chapters{make_hidden_surfaces_chapter(), make_visible_faces_chapter(),
                                   make_world_light_chapter(), make_perspective_chapter(),
                                   make_models_chapter()};
  return chapters;
}

}  // namespace temblor::app
