// A line of UTF-8 text with a cursor, for typing: the console's input line, chat, and the text fields of
// menus.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace temblor::client {

// The text is always valid UTF-8 without control characters (see sanitize_typed_text()). The cursor is before
// a character or at the end. Words are separated by spaces. All functions do nothing at the ends of the text.
class EditLine {
 public:
  static constexpr std::size_t kMaxBytes = 4096;

  const std::string& text() const { return text_; }
  std::size_t cursor() const { return cursor_; }  // byte offset

  // Replaces the text and moves the cursor to the end. Drops what exceeds kMaxBytes.
  void set(std::string_view text);
  void clear() { set(""); }

  // Inserts before the cursor. Returns how many bytes did not fit; whole characters are dropped from the end.
  std::size_t insert(std::string_view text);
  // Replaces the bytes from `begin` to the cursor; both must be at the start of a character.
  void replace_before_cursor(std::size_t begin, std::string_view text);

  // Each erases from the cursor to the named place and leaves the cursor where the text was.
  void erase_left();
  void erase_right();
  void erase_word_left();
  void erase_word_right();
  void erase_to_start();
  void erase_to_end();

  // Each moves the cursor without changing the text.
  void move_left() { cursor_ = previous_character(cursor_); }
  void move_right() { cursor_ = next_character(cursor_); }
  void move_word_left() { cursor_ = previous_word(cursor_); }
  void move_word_right() { cursor_ = next_word(cursor_); }
  void move_to_start() { cursor_ = 0; }
  void move_to_end() { cursor_ = text_.size(); }

 private:
  std::size_t previous_character(std::size_t at) const;
  std::size_t next_character(std::size_t at) const;
  std::size_t previous_word(std::size_t at) const;
  std::size_t next_word(std::size_t at) const;
  void erase(std::size_t begin, std::size_t end);

  std::string text_;
  std::size_t cursor_ = 0;
};

}  // namespace temblor::client
