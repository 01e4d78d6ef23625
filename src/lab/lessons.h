// The school's lessons, in the order in which to read them.
#pragma once

#include <span>
#include <string_view>

#include "lab/school/picture.h"

namespace temblor::lab::school {

struct Lesson {
  std::string_view name;            // a word, for file names
  std::string_view title, text;     // what to learn, and what the picture shows
  std::string_view file, function;  // to read, in src/lab/school
  Picture (*draw)(int width, int height);
};

std::span<const Lesson> list_lessons();

}  // namespace temblor::lab::school
