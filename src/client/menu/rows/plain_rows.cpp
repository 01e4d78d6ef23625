#include "client/menu/rows/plain_rows.h"

#include <algorithm>

#include "client/menu/lettering.h"

namespace temblor::client {
namespace {

// Runs an action, which may be empty. Without a sound of its own it has that of choosing.
Outcome run_action(const std::function<Outcome()>& action) {
  Outcome outcome = action ? action() : Outcome{};
  if (outcome.sound == MenuSound::kNone) outcome.sound = MenuSound::kEnter;
  return outcome;
}

int text_width(std::string_view text) {
  return static_cast<int>(text.size()) * kCharacterSide;
}

}  // namespace

std::size_t count_fitting_characters(int width) {
  return static_cast<std::size_t>(std::max(0, width / kCharacterSide));
}

void draw_left_and_right(const Canvas& canvas, const Box& box, std::string_view left,
                         std::string_view right) {
  const std::string shown_right = truncate(to_printable(right), count_fitting_characters(box.width));
  const int right_x = box.right() - text_width(shown_right);
  const int left_width = shown_right.empty() ? box.width : right_x - kCharacterSide - box.x;
  canvas.draw_text(truncate(to_printable(left), count_fitting_characters(left_width)), box.x, box.y);
  canvas.draw_text(shown_right, right_x, box.y);
}

void ActionRow::draw(const Canvas& canvas, const RowPlace& place) const {
  canvas.draw_text(truncate(to_printable(label_), count_fitting_characters(place.box.width / place.letters)),
                   place.box.x, place.box.y, place.letters);
}

Outcome ActionRow::activate() {
  return run_action(action_);
}

ListRow::ListRow(ListEntry entry)
    : entry_(std::move(entry)), search_text_(entry_.left + ' ' + entry_.middle + ' ' + entry_.right) {}

void ListRow::draw(const Canvas& canvas, const RowPlace& place) const {
  // The longest name that the game chooses itself, "autosave2", and a gap.
  constexpr int kMiddleX = 10 * kCharacterSide, kMinMiddle = 12 * kCharacterSide;
  const Box& box = place.box;
  const int middle_width = box.width - kMiddleX;
  if (entry_.middle.empty() || middle_width < kMinMiddle)
    return draw_left_and_right(canvas, box, entry_.left, entry_.right);
  const Box left{box.x, box.y, kMiddleX - kCharacterSide, box.height};
  draw_left_and_right(canvas, left, entry_.left, "");
  draw_left_and_right(canvas, {box.x + kMiddleX, box.y, middle_width, box.height}, entry_.middle,
                      entry_.right);
}

Outcome ListRow::activate() {
  return run_action(entry_.choose);
}

void HeadingRow::draw(const Canvas& canvas, const RowPlace& place) const {
  draw_left_and_right(canvas, place.box, to_second_color(left_), to_second_color(right_));
}

}  // namespace temblor::client
