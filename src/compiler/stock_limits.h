// The limits of the original engine and its compilers, which newer engines raise (numbers from the file
// format's 16-bit fields, and from the published limits of id's map tools).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/bsp/draft.h"
#include "compiler/report.h"
#include "formats/levels/bsp.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// How many records or bytes of a kind a level has.
struct PartCount {
  const char* what;  // plural: "faces", "bytes of light"
  std::size_t count, limit;

  bool is_exceeded() const { return count > limit; }
};

// Records of the geometry, in the order of the file's lumps.
std::vector<PartCount> count_records(const formats::Bsp& bsp);
// Bytes of textures, entity text, visibility, and light.
std::vector<PartCount> count_bytes(const formats::Bsp& bsp);
// Both, records first.
std::vector<PartCount> count_parts(const formats::Bsp& bsp);

// The map that a level was made of, to name places in it. `brush_entities` as in Draft.
struct LimitPlaces {
  const formats::Map& map;
  std::span<const BrushEntity> brush_entities;
};

// Adds a warning for each limit that the records exceed: it names the entity whose brushes exceed it first,
// and its line; in the world, the entity that adds most brushes to it. `after_model`: count_records() after
// each model was added, in which records that belong to no model may be missing. Warns, too, about a level
// that reaches beyond 4096 units from the origin.
void warn_about_records(const LimitPlaces& places, const formats::Bsp& bsp,
                        std::span<const std::vector<PartCount>> after_model, Warnings& io_warnings);

// The same for the bytes of a finished level. Names the largest texture and the first side that has it, the
// entity with the longest text, and the entity with most faces.
void warn_about_bytes(const LimitPlaces& places, const formats::Bsp& bsp, Warnings& io_warnings);

}  // namespace temblor::compiler
