// One line of text that is being typed.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace temblor::client {

// The text is valid UTF-8 without control characters, whatever comes in (see typed_text()). The cursor stands
// before a character or at the end. A word is what has no space in it.
class EditLine {
 public:
  static constexpr std::size_t kMaxBytes = 4096;

  const std::string& text() const { return text_; }
  std::size_t cursor() const { return cursor_; }  // in bytes

  // The cursor goes to the end. What has no room is left out.
  void set(std::string_view text);
  void clear() { set(""); }

  // Before the cursor. Returns how many bytes were left out for want of room: whole characters from the end.
  std::size_t insert(std::string_view text);
  // Puts text in the place of the bytes from `begin` to the cursor; both are characters' beginnings.
  void replace_before_cursor(std::size_t begin, std::string_view text);

  void erase_left();
  void erase_right();
  void erase_word_left();
  void erase_word_right();
  void erase_to_begin();
  void erase_to_end();

  void move_left() { cursor_ = left_of(cursor_); }
  void move_right() { cursor_ = right_of(cursor_); }
  void move_word_left() { cursor_ = word_left_of(cursor_); }
  void move_word_right() { cursor_ = word_right_of(cursor_); }
  void move_to_begin() { cursor_ = 0; }
  void move_to_end() { cursor_ = text_.size(); }

 private:
  std::size_t left_of(std::size_t at) const;
  std::size_t right_of(std::size_t at) const;
  std::size_t word_left_of(std::size_t at) const;
  std::size_t word_right_of(std::size_t at) const;
  void erase(std::size_t begin, std::size_t end);

  std::string text_;
  std::size_t cursor_ = 0;
};

}  // namespace temblor::client
