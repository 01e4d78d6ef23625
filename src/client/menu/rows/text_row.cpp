#include "client/menu/rows/text_row.h"

#include <algorithm>
#include <cmath>

#include "client/menu/lettering.h"
#include "client/menu/rows/choice_rows.h"
#include "client/menu/rows/plain_rows.h"

namespace temblor::client {

using platform::Key;

namespace {

// Keys that end editing and then do what they do on any row.
bool leaves_row(Key key) {
  return key == Key::kUpArrow || key == Key::kDownArrow || key == Key::kPageUp || key == Key::kPageDown ||
         key == Key::kTab || key >= Key::kMouse1;
}

}  // namespace

void LineEdit::insert(std::string_view typed) {
  for (const char c : typed)
    if (c >= ' ' && c <= '~' && text_.size() < max_chars_)
      text_.insert(text_.begin() + static_cast<std::ptrdiff_t>(caret_++), c);
}

void LineEdit::erase_before() {
  if (caret_ > 0) text_.erase(--caret_, 1);
}

void LineEdit::erase_after() {
  if (caret_ < text_.size()) text_.erase(caret_, 1);
}

void LineEdit::move(int chars) {
  caret_ = static_cast<std::size_t>(std::clamp(static_cast<std::ptrdiff_t>(caret_) + chars, std::ptrdiff_t{0},
                                               static_cast<std::ptrdiff_t>(text_.size())));
}

// A character outside the list becomes its first one.
void LineEdit::cycle_letter(int steps) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789.:-_ ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  constexpr auto kCount = static_cast<int>(kLetters.size());
  if (caret_ == 0) return insert(kLetters.substr(0, 1));
  char& letter = text_[caret_ - 1];
  const std::size_t at = kLetters.find(letter);
  const int from = at == std::string_view::npos ? 0 : static_cast<int>(at) + steps;
  letter = kLetters[static_cast<std::size_t>((from % kCount + kCount) % kCount)];
}

// Long text scrolls so that the caret stays visible.
void TextRow::draw(const Canvas& canvas, const RowPlace& place) const {
  constexpr double kBlinkSeconds = 0.5;
  constexpr std::uint8_t kField = 15;  // the brightest gray
  const Box right = value_box(place);
  const std::size_t chars = count_fitting_characters(right.width);
  canvas.fill({right.x - 2, right.y - 1, right.width + 2, kCharacterSide + 2}, kField, kFaintOpacity);
  if (!edit_ || chars < 2) return draw_label_and_value(canvas, place, label_, parts_.read(), false);
  draw_label_and_value(canvas, place, label_, "", false);
  const std::size_t first = edit_->caret() + 1 > chars ? edit_->caret() + 1 - chars : 0;
  canvas.draw_text(std::string_view(edit_->text()).substr(first, chars), right.x, right.y);
  if (std::fmod(std::abs(place.time_s), 2 * kBlinkSeconds) < kBlinkSeconds)
    canvas.draw_character(glyph::kBlock, right.x + static_cast<int>(edit_->caret() - first) * kCharacterSide,
                          right.y);
}

Outcome TextRow::activate() {
  edit_.emplace(parts_.read(), parts_.max_chars);
  ctrl_ = false;
  return {.sound = MenuSound::kEnter};
}

std::optional<Outcome> TextRow::clear() {
  Outcome outcome = activate();
  edit_.emplace("", parts_.max_chars);
  return outcome;
}

bool TextRow::type(std::string_view text) {
  activate();
  edit_->insert(text);
  return true;
}

void TextRow::stop_waiting() {
  if (edit_) (void)finish();
}

Outcome TextRow::finish() {
  Outcome outcome = parts_.write(edit_->text());
  edit_.reset();
  return outcome;
}

bool TextRow::handle(const platform::InputEvent& event, Outcome& out_outcome) {
  if (const auto* const typed = std::get_if<platform::TextTyped>(&event.what)) {
    edit_->insert(typed->text);
    return true;
  }
  if (std::holds_alternative<platform::FocusChanged>(event.what)) ctrl_ = false;
  const auto* const change = std::get_if<platform::KeyChange>(&event.what);
  return change != nullptr && handle_key(*change, out_outcome);
}

// Typing without a keyboard; see TextRow.
bool TextRow::handle_pad(Key key) {
  constexpr int kFarLetters = 8;
  switch (key) {
    case Key::kPadUp:
      edit_->cycle_letter(1);
      return true;
    case Key::kPadDown:
      edit_->cycle_letter(-1);
      return true;
    case Key::kPadLeftShoulder:
      edit_->cycle_letter(-kFarLetters);
      return true;
    case Key::kPadRightShoulder:
      edit_->cycle_letter(kFarLetters);
      return true;
    case Key::kPadRight:
      if (edit_->caret() < edit_->text().size())
        edit_->move(1);
      else
        edit_->insert("a");
      return true;
    case Key::kPadLeft:
    case Key::kPadX:
      edit_->erase_before();
      return true;
    default:
      return false;
  }
}

bool TextRow::handle_key(const platform::KeyChange& change, Outcome& out_outcome) {
  if (change.key == Key::kCtrl) ctrl_ = change.down;
  if (!change.down) return false;
  switch (change.key) {
    case Key::kEnter:
    case Key::kKeypadEnter:
    case Key::kPadA:
      out_outcome = finish();
      out_outcome.sound = MenuSound::kEnter;
      return true;
    case Key::kEscape:
    case Key::kPadB:
      edit_.reset();
      return true;
    case Key::kBackspace:
      edit_->erase_before();
      return true;
    case Key::kDelete:
      edit_->erase_after();
      return true;
    case Key::kLeftArrow:
      edit_->move(-1);
      return true;
    case Key::kRightArrow:
      edit_->move(1);
      return true;
    case Key::kHome:
      edit_->go_to_start();
      return true;
    case Key::kEnd:
      edit_->go_to_end();
      return true;
    default:
      break;
  }
  if (handle_pad(change.key)) return true;
  if (leaves_row(change.key)) {
    stop_waiting();
    return false;
  }
  if (ctrl_ && change.key == Key{'v'} && parts_.clipboard) edit_->insert(parts_.clipboard());
  return true;  // letters arrive as TextTyped events as well
}

}  // namespace temblor::client
