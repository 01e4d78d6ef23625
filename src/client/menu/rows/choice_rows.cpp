#include "client/menu/rows/choice_rows.h"

#include <algorithm>

#include "client/menu/lettering.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {

Box value_box(const RowPlace& place) {
  const Box& box = place.box;
  return {place.value_x, box.y + place.value_down, box.right() - place.value_x,
          box.height - place.value_down};
}

void draw_label_and_value(const Canvas& canvas, const RowPlace& place, std::string_view label,
                          std::string_view value, bool marked) {
  const Box& box = place.box;
  const Box right = value_box(place);
  const int label_width = place.value_down > 0 ? box.width : right.x - box.x - kCharacterSide;
  canvas.draw_text(truncate(to_printable(label), count_fitting_characters(label_width)), box.x, box.y);
  const std::size_t chars = count_fitting_characters(right.width);
  if (!marked || chars < 3) return canvas.draw_text(truncate(to_printable(value), chars), right.x, right.y);
  // The arrows are outside the column, so that the value does not move when its row is selected.
  const std::string text = truncate(to_printable(value), chars - 1);
  canvas.draw_text(to_second_color("<"), right.x - kCharacterSide, right.y);
  canvas.draw_text(text, right.x, right.y);
  canvas.draw_text(to_second_color(">"), right.x + static_cast<int>(text.size()) * kCharacterSide, right.y);
}

void ChoiceRow::draw(const Canvas& canvas, const RowPlace& place) const {
  draw_label_and_value(canvas, place, label_, value(), place.selected && count() > 1);
}

Outcome ChoiceRow::adjust(int steps) {
  const int values = count();
  if (values < 2) return {};
  const int from = std::max(chosen(), 0);
  choose(((from + steps) % values + values) % values);
  return {.sound = MenuSound::kAdjust};
}

Outcome LocalChoiceRow::adjust(int steps) {
  Outcome outcome = ChoiceRow::adjust(steps);
  outcome.refresh = parts_.refresh;
  return outcome;
}

std::string LocalChoiceRow::value() const {
  const int number = chosen();
  return number >= 0 && number < count() ? parts_.names[static_cast<std::size_t>(number)] : "-";
}

}  // namespace temblor::client
