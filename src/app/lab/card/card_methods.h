// The ways to draw a level with a graphics card that the laboratory compares, and what the article says of
// them.
#pragma once

#include <span>
#include <string>

#include "render_gl/draw_options.h"

namespace temblor::app {

struct CardMethod {
  render_gl::WorldMethod method;
  const char* name;     // of a table's row: "light pass"
  const char* title;    // "The light map in a second pass"
  const char* summary;  // one sentence
  const char* claim;    // of the article, in our words
  // How it works here, and how its picture differs.
  const char* explanation;
};

std::span<const CardMethod> list_card_methods();
const CardMethod& find_card_method(render_gl::WorldMethod method);

// For `temblor lab list`.
std::string describe_card_methods();

}  // namespace temblor::app
