#include "client/menu/rows/binding_row.h"

#include <fmt/format.h>

#include <cmath>

#include "client/input/key_names.h"
#include "client/menu/lettering.h"
#include "client/menu/page.h"
#include "client/menu/rows/choice_rows.h"
#include "command/text.h"

namespace temblor::client {

std::vector<platform::Key> BindingRow::keys() const {
  return call_or_default(content_->find_keys, std::string_view(commands_));
}

std::string BindingRow::join_key_names(std::string_view between) const {
  std::string words;
  for (const platform::Key key : keys()) {
    if (!words.empty()) words += between;
    words += key_name(key);
  }
  return words;
}

std::string BindingRow::help() const {
  if (waiting_) return "Press a key or button. Escape cancels.";
  constexpr std::string_view kHelp = "Enter adds a key. Backspace, Delete or gamepad X clears them.";
  // The row has no room for more than two keys, so the help lists all of them.
  return keys().size() > 2 ? fmt::format("{}. {}", join_key_names(", "), kHelp) : std::string(kHelp);
}

void BindingRow::draw(const Canvas& canvas, const RowPlace& place) const {
  constexpr double kBlinkSeconds = 0.4;
  constexpr std::string_view kPrompt = "press a key";
  if (waiting_) {
    const bool bright = std::fmod(std::abs(place.time_s), 2 * kBlinkSeconds) < kBlinkSeconds;
    return draw_label_and_value(canvas, place, label_,
                                bright ? std::string(kPrompt) : to_second_color(kPrompt), false);
  }
  const std::string words = join_key_names(to_second_color(" or "));
  draw_label_and_value(canvas, place, label_, words.empty() ? to_second_color("-") : words, false);
}

Outcome BindingRow::activate() {
  waiting_ = true;
  return {.sound = MenuSound::kEnter};
}

std::optional<Outcome> BindingRow::clear() {
  Outcome outcome{.sound = MenuSound::kEnter};
  for (const platform::Key key : keys())
    outcome.commands.push_back(command::join_words({"unbind", key_name(key)}));
  return outcome;
}

// Takes the first key that is pressed, whichever it is; only Escape cannot be bound here. Stick moves are
// used up, so that they do not leave the row.
bool BindingRow::handle(const platform::InputEvent& event, Outcome& out_outcome) {
  const auto* const change = std::get_if<platform::KeyChange>(&event.what);
  if (change == nullptr) return std::holds_alternative<platform::PadAxisMoved>(event.what);
  if (!change->down || change->repeated) return false;
  waiting_ = false;
  if (change->key == platform::Key::kEscape) return true;
  out_outcome.sound = MenuSound::kEnter;
  out_outcome.commands.push_back(command::join_words({"bind", key_name(change->key), commands_}));
  return true;
}

}  // namespace temblor::client
