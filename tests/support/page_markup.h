// Checks of the HTML pages that our commands write.
#pragma once

#include <string>

namespace temblor::test {

// Removes the contents of embedded pictures.
std::string without_pictures(std::string text);

// Returns the first fault of a page that should be well-formed XML: tags that do not match, attributes
// without quotes, or loose markup characters. Empty: none.
std::string find_markup_fault(std::string text);

}  // namespace temblor::test
