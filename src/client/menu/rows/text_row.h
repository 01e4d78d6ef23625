// A row with a line of text that can be typed.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "client/menu/rows/row.h"

namespace temblor::client {

// A line of text with a caret in it; printable ASCII, as the console's characters are.
class LineEdit {
 public:
  static constexpr std::size_t kMaxChars = 200;

  explicit LineEdit(std::string text) : text_(std::move(text)), caret_(text_.size()) {}
  const std::string& text() const { return text_; }
  std::size_t caret() const { return caret_; }

  // Drops what is not printable ASCII, and what there is no room for.
  void insert(std::string_view typed);
  void erase_before();
  void erase_behind();
  void move(int chars);
  // The character before the caret becomes the next of those that names and addresses are made of; where
  // there is none, the first one is inserted.
  void turn(int steps);
  void go_to_begin() { caret_ = 0; }
  void go_to_end() { caret_ = text_.size(); }

 private:
  std::string text_;
  std::size_t caret_;
};

// Enter begins to edit and takes what was written; Escape leaves it as it was. On a gamepad up and down turn
// the letter at the caret (the shoulders by eight), right adds one, left and X take one away.
class TextRow : public Row {
 public:
  struct Parts {
    std::function<std::string()> read;
    std::function<Outcome(std::string)> write;  // what Enter does
    std::string help = {};
    std::function<std::string()> clipboard = {};
  };
  TextRow(std::string label, Parts parts) : label_(std::move(label)), parts_(std::move(parts)) {}

  std::string_view label() const override { return label_; }
  std::string help() const override { return parts_.help; }
  void draw(const Canvas& canvas, const RowPlace& place) const override;
  Outcome activate() override;
  std::optional<Outcome> clear() override;
  bool type(std::string_view text) override;

  bool is_waiting() const override { return edit_.has_value(); }
  bool take(const platform::InputEvent& event, Outcome& out_outcome) override;
  // Keeps what was written, without what Enter would do beyond that.
  void stop_waiting() override;

 private:
  bool take_key(const platform::KeyChange& change, Outcome& out_outcome);
  bool take_pad(platform::Key key);
  Outcome finish();

  std::string label_;
  Parts parts_;
  std::optional<LineEdit> edit_;  // while it is edited
  bool ctrl_ = false;             // is held
};

}  // namespace temblor::client
