// A matrix of bits in one block of memory, processed 64 bits at a time. Rows are sets of clusters.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace temblor::compiler {

// The number of rows and columns is fixed.
class BitMatrix {
 public:
  using Word = std::uint64_t;

  BitMatrix() = default;
  // All bits are 0.
  BitMatrix(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), words_((columns + 63) / 64), bits_(rows * words_) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }

  // Bit c of a row is bit c % 64 of word c / 64. Bits beyond the last column are 0.
  std::span<Word> row(std::size_t index) { return {bits_.data() + index * words_, words_}; }
  std::span<const Word> row(std::size_t index) const { return {bits_.data() + index * words_, words_}; }

  bool at(std::size_t row_index, std::size_t column) const {
    return (row(row_index)[column / 64] >> (column % 64) & 1) != 0;
  }
  void set(std::size_t row_index, std::size_t column) {
    row(row_index)[column / 64] |= Word{1} << (column % 64);
  }
  bool operator==(const BitMatrix&) const = default;

 private:
  std::size_t rows_ = 0, columns_ = 0, words_ = 0;
  std::vector<Word> bits_;
};

// Bits of a single row.
inline bool has_bit(std::span<const BitMatrix::Word> row, std::size_t bit) {
  return (row[bit / 64] >> (bit % 64) & 1) != 0;
}
inline void set_bit(std::span<BitMatrix::Word> row, std::size_t bit) {
  row[bit / 64] |= BitMatrix::Word{1} << (bit % 64);
}
inline std::size_t count_bits(std::span<const BitMatrix::Word> row) {
  std::size_t count = 0;
  for (const BitMatrix::Word word : row) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}
// io_row |= other, and io_row &= other; rows of one length.
inline void add_bits(std::span<const BitMatrix::Word> other, std::span<BitMatrix::Word> io_row) {
  for (std::size_t i = 0; i < io_row.size(); ++i) io_row[i] |= other[i];
}
inline void keep_bits(std::span<const BitMatrix::Word> other, std::span<BitMatrix::Word> io_row) {
  for (std::size_t i = 0; i < io_row.size(); ++i) io_row[i] &= other[i];
}

// Swaps rows and columns.
inline BitMatrix transpose(const BitMatrix& matrix) {
  BitMatrix transposed(matrix.columns(), matrix.rows());
  for (std::size_t a = 0; a < matrix.rows(); ++a) {
    const auto row = matrix.row(a);
    for (std::size_t word = 0; word < row.size(); ++word)
      for (BitMatrix::Word rest = row[word]; rest != 0; rest &= rest - 1)
        transposed.set(word * 64 + static_cast<std::size_t>(std::countr_zero(rest)), a);
  }
  return transposed;
}

}  // namespace temblor::compiler
