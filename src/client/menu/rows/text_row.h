// A row with a line of text to edit: names, addresses, numbers.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "client/menu/rows/row.h"

namespace temblor::client {

// A line of printable ASCII with a caret in it.
class LineEdit {
 public:
  static constexpr std::size_t kMaxChars = 200;

  explicit LineEdit(std::string text, std::size_t max_chars = kMaxChars)
      : text_(std::move(text)), caret_(text_.size()), max_chars_(max_chars) {}
  const std::string& text() const { return text_; }
  std::size_t caret() const { return caret_; }  // 0 to text().size()

  // Drops characters that are not printable ASCII or exceed the limit.
  void insert(std::string_view typed);
  // Delete the character before or after the caret, or move the caret within the text.
  void erase_before();
  void erase_after();
  void move(int chars);
  // Replaces the character before the caret with the next one of the alphabet for names and addresses.
  // Inserts the first one if there is no character.
  void cycle_letter(int steps);
  void go_to_start() { caret_ = 0; }
  void go_to_end() { caret_ = text_.size(); }

 private:
  std::string text_;
  std::size_t caret_, max_chars_;
};

// Enter starts editing and accepts the text; Escape cancels. On a gamepad, up and down change the letter at
// the caret (the shoulder buttons by eight), right adds a letter, left and X delete one.
class TextRow : public Row {
 public:
  struct Parts {
    std::function<std::string()> read;
    std::function<Outcome(std::string)> write;  // called on Enter
    std::string help = {};
    std::function<std::string()> clipboard = {};
    std::size_t max_chars = LineEdit::kMaxChars;
  };
  TextRow(std::string label, Parts parts) : label_(std::move(label)), parts_(std::move(parts)) {}

  bool has_value() const override { return true; }
  std::string_view label() const override { return label_; }
  std::string help() const override { return parts_.help; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome activate() override;
  std::optional<Outcome> clear() override;  // starts editing with an empty line
  bool type(std::string_view text) override;

  bool is_waiting() const override { return edit_.has_value(); }
  bool handle(const platform::InputEvent& event, Outcome& out_outcome) override;
  // Stores the text, but drops the outcome that Enter would have had.
  void stop_waiting() override;

 private:
  bool handle_key(const platform::KeyChange& change, Outcome& out_outcome);
  bool handle_pad(platform::Key key);
  // Ends editing and hands the text to `write`.
  Outcome finish();

  std::string label_;
  Parts parts_;
  std::optional<LineEdit> edit_;  // while the row is edited
  bool ctrl_ = false;             // the key is held
};

}  // namespace temblor::client
