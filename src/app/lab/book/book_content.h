// The texts of the laboratory's book: chapters, explanations, the articles' claims, and rules for verdicts.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/lab/book/evidence.h"

namespace temblor::app {

enum class Holds { kYes, kPartly, kNo };

struct Verdict {
  Holds holds;
  std::string text;
};

// A technique with its parameters, as on the command line. lab::Technique has its summary and its article.
struct BookEntry {
  std::string_view technique;
  std::string_view explanation;
  std::string_view claim;      // of the article, in our words, with its numbers
  std::string_view optimized;  // how far our version is
  Verdict (*judge)(const Evidence& evidence);
  // Also show how its light shifts, in a film.
  bool has_film = false;
};

// The figures of a chapter's tables, besides times.
enum class BookColumns { kSurfaces, kLight, kTexels, kModels };

struct BookChapter {
  std::string_view file;  // NAME of NAME.html
  std::string_view title, introduction;
  std::span<const BookEntry> entries;
  BookColumns columns = BookColumns::kSurfaces;
  // Its techniques are measured in scenes of models.
  bool of_models = false;
};

std::span<const BookChapter> list_book_chapters();

// A number from the articles, and how it is measured here.
struct ArticleNumber {
  std::string_view article, claim, theirs;
  std::string (*ours)(const BookFigures& figures);
  // `ours` is of scenes of models.
  bool of_models = false;
};

std::span<const ArticleNumber> list_article_numbers();

}  // namespace temblor::app
