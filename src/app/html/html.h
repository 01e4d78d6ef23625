// Pieces of HTML pages. They are also well-formed XML.
#pragma once

#include <string>
#include <string_view>

#include "base/bytes.h"

namespace temblor::app {

// Returns a page from its first line to <body>. Its style sheet is that of all our pages and `more_style`.
std::string begin_page(std::string_view title, std::string_view more_style);

// Makes text from a file safe as content and as an attribute. Other characters than printable ASCII become
// '?'.
std::string escape_html(std::string_view text);

// Returns "data:image/png;base64,...", so that a page needs no other file.
std::string make_png_uri(base::Bytes png);

// Returns a horizontal bar that is `share` (0 to 1; larger is cut off) of its cell's width. `is_alarm`: in
// the color of a fault.
std::string make_bar(double share, bool is_alarm = false);

}  // namespace temblor::app
