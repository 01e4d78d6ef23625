#include "client/menu/rows/plain_rows.h"

#include <algorithm>

#include "client/menu/lettering.h"

namespace temblor::client {
namespace {

Outcome carry_out(const std::function<Outcome()>& action) {
  Outcome outcome = action ? action() : Outcome{};
  if (outcome.sound == MenuSound::kNone) outcome.sound = MenuSound::kEnter;
  return outcome;
}

int width_of(std::string_view text) {
  return static_cast<int>(text.size()) * kCharacterSide;
}

}  // namespace

std::size_t characters_in(int width) {
  return static_cast<std::size_t>(std::max(0, width / kCharacterSide));
}

void draw_left_and_right(const Canvas& canvas, const Box& box, std::string_view left,
                         std::string_view right) {
  const std::string shown_right = cut(shown(right), characters_in(box.width));
  const int right_x = box.right() - width_of(shown_right);
  const int left_width = shown_right.empty() ? box.width : right_x - kCharacterSide - box.x;
  canvas.text(cut(shown(left), characters_in(left_width)), box.x, box.y);
  canvas.text(shown_right, right_x, box.y);
}

void ActionRow::draw(const Canvas& canvas, const RowPlace& place) const {
  canvas.text(cut(shown(label_), characters_in(place.box.width / place.letters)), place.box.x, place.box.y,
              place.letters);
}

Outcome ActionRow::activate() {
  return carry_out(action_);
}

ListRow::ListRow(ListEntry entry)
    : entry_(std::move(entry)), search_text_(entry_.left + ' ' + entry_.middle + ' ' + entry_.right) {}

void ListRow::draw(const Canvas& canvas, const RowPlace& place) const {
  // The longest name that the game gives by itself, "autosave2", and a gap.
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
  return carry_out(entry_.choose);
}

void HeadingRow::draw(const Canvas& canvas, const RowPlace& place) const {
  draw_left_and_right(canvas, place.box, in_second_color(left_), in_second_color(right_));
}

}  // namespace temblor::client
