#include "client/menu/rows/choice_rows.h"

#include <algorithm>

#include "client/menu/lettering.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {

Box value_box(const RowPlace& place) {
  return {place.value_x, place.box.y, place.box.right() - place.value_x, place.box.height};
}

void draw_label_and_value(const Canvas& canvas, const RowPlace& place, std::string_view label,
                          std::string_view value, bool marked) {
  const Box& box = place.box;
  const Box right = value_box(place);
  canvas.text(cut(shown(label), characters_in(right.x - box.x - kCharacterSide)), box.x, box.y);
  const std::size_t chars = characters_in(right.width);
  if (!marked || chars < 3) return canvas.text(cut(shown(value), chars), right.x, right.y);
  // The value stays where it is while its row is passed.
  const std::string text = cut(shown(value), chars - 1);
  canvas.text(in_second_color("<"), right.x - kCharacterSide, right.y);
  canvas.text(text, right.x, right.y);
  canvas.text(in_second_color(">"), right.x + static_cast<int>(text.size()) * kCharacterSide, right.y);
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
