#include "client/console/edit_line.h"

#include "base/check.h"
#include "client/console/utf8.h"

namespace temblor::client {

void EditLine::set(std::string_view text) {
  text_.clear();
  cursor_ = 0;
  insert(text);
}

// Inserts as many whole characters as fit. `taken` is always at the end of a character.
std::size_t EditLine::insert(std::string_view text) {
  const std::string typed = sanitize_typed_text(text);
  const std::size_t room = kMaxBytes - text_.size();
  std::size_t taken = 0;
  if (typed.size() <= room) {
    taken = typed.size();
  } else {
    for (std::size_t next = character_length(typed, 0); next <= room; next += character_length(typed, next))
      taken = next;
  }
  text_.insert(cursor_, typed, 0, taken);
  cursor_ += taken;
  return typed.size() - taken;
}

void EditLine::replace_before_cursor(std::size_t begin, std::string_view text) {
  CHECK(begin <= cursor_, "{} {}", begin, cursor_);
  erase(begin, cursor_);
  insert(text);
}

// Continuation bytes of UTF-8 have length 0, so stepping back over them finds the start of the character.
std::size_t EditLine::previous_character(std::size_t at) const {
  if (at == 0) return 0;
  do --at;
  while (character_length(text_, at) == 0);
  return at;
}

std::size_t EditLine::next_character(std::size_t at) const {
  return at + character_length(text_, at);
}

std::size_t EditLine::previous_word(std::size_t at) const {
  while (at > 0 && text_[at - 1] == ' ') --at;
  while (at > 0 && text_[at - 1] != ' ') --at;
  return at;
}

std::size_t EditLine::next_word(std::size_t at) const {
  while (at < text_.size() && text_[at] == ' ') ++at;
  while (at < text_.size() && text_[at] != ' ') ++at;
  return at;
}

// Removes [begin, end) and puts the cursor there.
void EditLine::erase(std::size_t begin, std::size_t end) {
  text_.erase(begin, end - begin);
  cursor_ = begin;
}

void EditLine::erase_left() {
  erase(previous_character(cursor_), cursor_);
}
void EditLine::erase_right() {
  erase(cursor_, next_character(cursor_));
}
void EditLine::erase_word_left() {
  erase(previous_word(cursor_), cursor_);
}
void EditLine::erase_word_right() {
  erase(cursor_, next_word(cursor_));
}
void EditLine::erase_to_start() {
  erase(0, cursor_);
}
void EditLine::erase_to_end() {
  erase(cursor_, text_.size());
}

}  // namespace temblor::client
