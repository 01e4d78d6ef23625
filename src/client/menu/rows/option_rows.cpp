#include "client/menu/rows/option_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/menu/lettering.h"
#include "client/menu/rows/choice_rows.h"
#include "client/menu/rows/plain_rows.h"
#include "client/menu/rows/text_row.h"

namespace temblor::client {
namespace {

using command::Variable;
using command::VariableType;

// The variable of a row. It is looked up each time, as registering others invalidates pointers.
class BoundVariable {
 public:
  BoundVariable(command::Variables& io_variables, std::string_view name)
      : variables_(&io_variables), name_(name) {}

  const Variable& get() const {
    const Variable* const variable = variables_->find(name_);
    CHECK(variable != nullptr, "{}", name_);
    return *variable;
  }
  std::string help() const { return fmt::format("{} ({})", get().help, name_); }
  // A value that the variable rejects changes nothing.
  void set(std::string_view text) const { (void)variables_->set(name_, text); }
  void set_number(double value) const {
    const Variable& variable = get();
    const double allowed = std::clamp(value, variable.min, variable.max);
    set(variable.type == VariableType::kInt ? fmt::format("{:.0f}", allowed)
                                            : fmt::format("{:.7g}", allowed));
  }

 private:
  command::Variables* variables_;
  std::string name_;
};

// "on" or "off".
class ToggleRow : public ChoiceRow {
 public:
  ToggleRow(const BoundVariable& variable, std::string label)
      : ChoiceRow(std::move(label)), variable_(variable) {}
  std::string help() const override { return variable_.help(); }

 protected:
  std::string value() const override { return chosen() != 0 ? "on" : "off"; }
  int count() const override { return 2; }
  int chosen() const override { return variable_.get().number != 0 ? 1 : 0; }
  void choose(int number) override { variable_.set(number != 0 ? "1" : "0"); }

 private:
  BoundVariable variable_;
};

// A variable with a list of allowed texts.
class VariableChoiceRow : public ChoiceRow {
 public:
  VariableChoiceRow(const BoundVariable& variable, const OptionLook& look)
      : ChoiceRow(std::string(look.label)), variable_(variable), names_(look.names) {}
  std::string help() const override { return variable_.help(); }

 protected:
  std::string value() const override {
    const auto number = static_cast<std::size_t>(chosen());
    return number < names_.size() ? std::string(names_[number]) : variable_.get().text;
  }
  int count() const override { return static_cast<int>(variable_.get().choices.size()); }
  int chosen() const override { return static_cast<int>(variable_.get().number); }
  void choose(int number) override {
    variable_.set(std::string(variable_.get().choices[static_cast<std::size_t>(number)]));
  }

 private:
  BoundVariable variable_;
  std::span<const std::string_view> names_;  // shown in place of the choices; may be empty
};

// A number variable whose values 0, 1, ... have names.
class NamedNumberRow : public ChoiceRow {
 public:
  NamedNumberRow(const BoundVariable& variable, const OptionLook& look)
      : ChoiceRow(std::string(look.label)), variable_(variable), names_(look.names) {}
  std::string help() const override { return variable_.help(); }

 protected:
  std::string value() const override {
    const int number = chosen();
    return number < 0 ? variable_.get().text : std::string(names_[static_cast<std::size_t>(number)]);
  }
  int count() const override { return static_cast<int>(names_.size()); }
  int chosen() const override {
    const double number = std::round(variable_.get().number);
    return number >= 0 && number < static_cast<double>(names_.size()) ? static_cast<int>(number) : -1;
  }
  void choose(int number) override { variable_.set_number(number); }

 private:
  BoundVariable variable_;
  std::span<const std::string_view> names_;
};

// A number as a slider with the value beside it: "[----o-------] 55%". The slider moves in steps; the console
// can set values in between.
class SliderRow : public Row {
 public:
  SliderRow(const BoundVariable& variable, const OptionLook& look);

  bool has_value() const override { return true; }
  std::string_view label() const override { return look_.label; }
  std::string help() const override { return variable_.help(); }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome adjust(int steps) override;
  std::optional<Box> slide_box(const RowPlace& place) const override;
  void slide(double fraction) override;

 private:
  static int count_middles(const RowPlace& place);
  double steps() const { return std::max(1.0, std::round((look_.high - look_.low) / look_.step)); }
  void go_to_step(double number);
  std::string number() const;

  BoundVariable variable_;
  OptionLook look_;
};

// Narrows the look's range to what the variable accepts, and makes sure that there is a positive step.
SliderRow::SliderRow(const BoundVariable& variable, const OptionLook& look)
    : variable_(variable), look_(look) {
  constexpr double kSteps = 20;
  const Variable& bound = variable.get();
  if (look_.low == look_.high) {
    look_.low = bound.min;
    look_.high = bound.max;
  }
  look_.low = std::max(look_.low, bound.min);
  look_.high = std::max(look_.low, std::min(look_.high, bound.max));
  if (look_.step <= 0) look_.step = (look_.high - look_.low) / kSteps;
  if (bound.type == VariableType::kInt) look_.step = std::max(1.0, std::round(look_.step));
  if (look_.step <= 0) look_.step = 1;
}

// Characters between the slider's ends; 0 if the row has room only for the number.
int SliderRow::count_middles(const RowPlace& place) {
  constexpr int kEnds = 2, kNumberChars = 7, kMin = 4, kMax = 12;
  const auto room = static_cast<int>(count_fitting_characters(value_box(place).width)) - kEnds;
  return room < kMin ? 0 : std::clamp(room - kNumberChars, kMin, kMax);
}

std::optional<Box> SliderRow::slide_box(const RowPlace& place) const {
  const int count = count_middles(place);
  if (count == 0) return std::nullopt;
  // From the center of the leftmost knob to the center of the rightmost.
  const Box value = value_box(place);
  return Box{value.x + kCharacterSide * 3 / 2, value.y, (count - 1) * kCharacterSide, value.height};
}

void SliderRow::draw(const Canvas& canvas, const RowPlace& place) const {
  const Box right = value_box(place);
  const int count = count_middles(place);
  if (count == 0) return draw_label_and_value(canvas, place, look_.label, number(), false);
  draw_label_and_value(canvas, place, look_.label, "", false);
  canvas.draw_character(glyph::kSliderLeft, right.x, right.y);
  for (int i = 1; i <= count; ++i)
    canvas.draw_character(glyph::kSliderMiddle, right.x + i * kCharacterSide, right.y);
  canvas.draw_character(glyph::kSliderRight, right.x + (count + 1) * kCharacterSide, right.y);
  const double range = look_.high - look_.low;
  const double fraction =
      range > 0 ? std::clamp((variable_.get().number - look_.low) / range, 0.0, 1.0) : 0.0;
  canvas.draw_character(glyph::kSliderKnob,
                        right.x + kCharacterSide + static_cast<int>(fraction * (count - 1) * kCharacterSide),
                        right.y);
  const int number_x = right.x + (count + 2) * kCharacterSide + kCharacterSide / 2;
  canvas.draw_text(truncate(number(), count_fitting_characters(right.right() - number_x)), number_x, right.y);
}

std::string SliderRow::number() const {
  const double value = variable_.get().number;
  if (value == 0 && !look_.zero.empty()) return std::string(look_.zero);
  constexpr double kWithoutFraction = 1000;
  const double shown_value = value * look_.shown_factor;
  return std::abs(shown_value) < kWithoutFraction ? fmt::format("{:.4g}{}", shown_value, look_.unit)
                                                  : fmt::format("{:.0f}{}", shown_value, look_.unit);
}

void SliderRow::go_to_step(double number) {
  variable_.set_number(look_.low + std::clamp(number, 0.0, steps()) * look_.step);
}

Outcome SliderRow::adjust(int count) {
  const double at = (std::clamp(variable_.get().number, look_.low, look_.high) - look_.low) / look_.step;
  // A value between two steps moves to the next step in that direction.
  constexpr double kRounding = 1e-6;
  go_to_step(count > 0 ? std::floor(at + kRounding) + count : std::ceil(at - kRounding) + count);
  return {.sound = MenuSound::kAdjust};
}

void SliderRow::slide(double fraction) {
  go_to_step(std::round(std::clamp(fraction, 0.0, 1.0) * steps()));
}

// One of the colors of players' clothes, as swatches.
class ColorRow : public ChoiceRow {
 public:
  ColorRow(const BoundVariable& variable, std::string label)
      : ChoiceRow(std::move(label)), variable_(variable) {}

  std::string help() const override { return variable_.help(); }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  std::optional<Box> slide_box(const RowPlace& place) const override {
    const Box value = value_box(place);
    return Box{value.x, value.y, kColors * kCharacterSide, value.height};
  }
  void slide(double fraction) override {
    choose(std::min(static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kColors), kColors - 1));
  }

 protected:
  std::string value() const override { return {}; }
  int count() const override { return kColors; }
  int chosen() const override { return static_cast<int>(variable_.get().number); }
  void choose(int number) override { variable_.set_number(number); }

 private:
  static constexpr int kColors = 14;

  BoundVariable variable_;
};

void ColorRow::draw(const Canvas& canvas, const RowPlace& place) const {
  constexpr int kPaletteRow = 16, kShade = 8;
  constexpr std::uint8_t kMark = 254;  // bright in every Quake palette
  draw_label_and_value(canvas, place, label(), "", false);
  for (int i = 0; i < kColors; ++i) {
    const Box swatch{place.value_x + i * kCharacterSide, value_box(place).y, kCharacterSide, kCharacterSide};
    if (i == chosen()) canvas.fill({swatch.x - 1, swatch.y - 1, swatch.width + 2, swatch.height + 2}, kMark);
    canvas.fill(swatch, static_cast<std::uint8_t>(i * kPaletteRow + kShade));
  }
}

}  // namespace

std::unique_ptr<Row> make_option_row(command::Variables& io_variables, const OptionLook& look) {
  const Variable* const variable = io_variables.find(look.variable);
  if (variable == nullptr) return nullptr;
  const BoundVariable bound(io_variables, look.variable);
  std::string label(look.label);
  switch (variable->type) {
    case VariableType::kBool:
      return std::make_unique<ToggleRow>(bound, std::move(label));
    case VariableType::kChoice:
      return std::make_unique<VariableChoiceRow>(bound, look);
    case VariableType::kInt:
    case VariableType::kFloat:
      if (look.names.empty()) return std::make_unique<SliderRow>(bound, look);
      return std::make_unique<NamedNumberRow>(bound, look);
    case VariableType::kText:
      break;
  }
  return std::make_unique<TextRow>(std::move(label), TextRow::Parts{
                                                         .read = [bound] { return bound.get().text; },
                                                         .write =
                                                             [bound](std::string text) {
                                                               bound.set(text);
                                                               return Outcome{};
                                                             },
                                                         .help = bound.help(),
                                                     });
}

std::unique_ptr<Row> make_color_row(command::Variables& io_variables, const OptionLook& look) {
  const Variable* const variable = io_variables.find(look.variable);
  if (variable == nullptr || variable->type != VariableType::kInt) return nullptr;
  return std::make_unique<ColorRow>(BoundVariable(io_variables, look.variable), std::string(look.label));
}

}  // namespace temblor::client
