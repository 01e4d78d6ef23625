// Usage: write_shape_code FILE.cpp
// Writes the drawing code of all shapes (built_shapes.h). A part of the build.
#include <bit>
#include <cstdio>
#include <fstream>
#include <ostream>

#include "lab/models/small/small_shapes.h"

namespace temblor::lab {

namespace {

constexpr const char* kBegin = R"(// Written by src/lab/models/small/generator/write_shape_code.cpp
#include "lab/models/small/built_shapes.h"

namespace temblor::lab {
namespace {

// A row of the target, from the column of a shape's first pixel.
template <typename Pixel>
struct TargetRow {
  float* depth;
  Pixel* pixels;
};
template <typename Pixel>
TargetRow<Pixel> find_target_row(const SmallDrawing& drawing, std::size_t row) {
  return {drawing.depth + row * drawing.width, static_cast<Pixel*>(drawing.pixels) + row * drawing.width};
}
template <typename Pixel>
void draw(const SmallDrawing& drawing, const TargetRow<Pixel>& to, std::size_t column, Values values) {
  draw_small_pixel(drawing, values, to.depth[column], to.pixels[column]);
}
)";

// A bit for each column that has a pixel.
std::uint32_t find_columns(std::uint32_t mask) {
  std::uint32_t columns = 0;
  for (; mask != 0; mask >>= SmallMasks::kMaxSide) columns |= mask & 0b11111;
  return columns;
}

void write_shape(std::size_t number, std::uint32_t mask, std::ostream& io_out) {
  io_out << "\ntemplate <typename Pixel>\nvoid draw_shape_" << number << "(const SmallDrawing& drawing) {\n";
  for (std::uint32_t columns = find_columns(mask); columns != 0; columns &= columns - 1) {
    const int column = std::countr_zero(columns);
    io_out << "  const Values column_" << column << " = find_column(drawing, " << column << ");\n";
  }
  for (int row = 0; mask != 0; ++row, mask >>= SmallMasks::kMaxSide) {
    if ((mask & 0b11111) == 0) continue;
    io_out << "  const Values row_" << row << " = find_row(drawing, " << row << ");\n"
           << "  const auto to_" << row << " = find_target_row<Pixel>(drawing, " << row << ");\n";
    for (std::uint32_t left = mask & 0b11111; left != 0; left &= left - 1) {
      const int column = std::countr_zero(left);
      io_out << "  draw(drawing, to_" << row << ", " << column << ", column_" << column << " + row_" << row
             << ");\n";
    }
  }
  io_out << "}\n";
}

void write_table(const char* name, const char* pixel, std::size_t shapes, std::ostream& io_out) {
  io_out << "constexpr DrawShape " << name << "[] = {\n";
  for (std::size_t i = 0; i < shapes; ++i) io_out << "    draw_shape_" << i << "<" << pixel << ">,\n";
  io_out << "};\n";
}

void write_code(const SmallShapes& shapes, std::ostream& io_out) {
  io_out << kBegin;
  for (std::size_t i = 0; i < shapes.masks().size(); ++i) write_shape(i, shapes.masks()[i], io_out);
  io_out << "\nconstexpr std::uint32_t kMasks[] = {\n";
  for (const std::uint32_t mask : shapes.masks()) io_out << "    " << mask << ",\n";
  io_out << "};\n";
  write_table("kIndexed", "std::uint8_t", shapes.masks().size(), io_out);
  write_table("kRgb", "std::uint32_t", shapes.masks().size(), io_out);
  io_out << "\n}  // namespace\n\nBuiltShapes list_built_shapes() {\n  return {kMasks, kIndexed, kRgb};\n}\n"
            "\n}  // namespace temblor::lab\n";
}

}  // namespace

}  // namespace temblor::lab

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: write_shape_code FILE.cpp\n", stderr);
    return 2;
  }
  std::ofstream out(argv[1]);
  temblor::lab::write_code(temblor::lab::SmallShapes(temblor::lab::SmallMasks()), out);
  out.close();
  if (!out) {
    std::fprintf(stderr, "cannot write %s\n", argv[1]);
    return 1;
  }
  return 0;
}
