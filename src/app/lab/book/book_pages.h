// The pages of the laboratory's book, from its texts and measurements. They are plain HTML without scripts,
// and well-formed XML.
#pragma once

#include <string>

#include "app/lab/book/book_content.h"

namespace temblor::app {

// The measurements, and the conditions that the pages name.
struct BookInput {
  const BookFigures& figures;
  const BookOptions& options;
  std::string processor;
  // The measurements of scenes of models; null: the same.
  const BookFigures* model_figures = nullptr;

  const BookFigures& choose_figures(bool of_models) const {
    return of_models && model_figures != nullptr ? *model_figures : figures;
  }
};

// The first page: how it was measured, all verdicts, and the articles' numbers next to ours.
std::string make_index_page(const BookInput& input);
std::string make_chapter_page(const BookInput& input, const BookChapter& chapter);

// The file of a technique's picture, "painter-pvs-0.png" for painter:pvs=0.
std::string picture_file_name(std::string_view technique);
// The file of its film, if it has one (BookEntry::has_film).
std::string film_file_name(std::string_view technique);

}  // namespace temblor::app
