// Lines, cells and numbers of tables that spreadsheets and finite-element programs write; private to
// lib/curved/stressfield.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::stressfield {

using Cells = std::vector<std::string_view>; // without quotes and blanks around them

// The separator of a line: ';', tab, ',' or blanks, the first of these that occurs outside of quotes.
char separator(std::string_view line);

// The cells of a line. An empty cell after the last separator is ignored; consecutive blanks are one separator.
void split(std::string_view line, char mark, Cells& out);

// Names that are separated by tabs or by two or more blanks.
void split_wide(std::string_view line, Cells& out);

// A cursor over lines, which end with "\n", "\r\n" or "\r".
class TextLines {
  public:
    explicit TextLines(std::string_view text) : text_(text) {}
    bool next(std::string_view& line); // without line end and surrounding blanks; false if there is none
    [[nodiscard]] std::size_t number() const { return number_; } // of the last line, from 1
    [[nodiscard]] bool ended() const { return ended_; }          // the last line had an end

  private:
    std::string_view text_;
    std::size_t at_ = 0, number_ = 0;
    bool ended_ = true;
};

enum class Decimal { point, comma };

// Evidence for the decimal mark of numbers. "0,5" and "1.234.567" prove a comma, "0.5" and "1,234,567" a point;
// "1,234" is ambiguous.
class DecimalEvidence {
  public:
    void add(std::string_view cell);
    [[nodiscard]] bool comma() const { return comma_; }
    [[nodiscard]] bool point() const { return point_; }
    [[nodiscard]] const std::string& doubtful() const { return doubtful_; } // the first ambiguous number

  private:
    bool comma_ = false, point_ = false;
    std::string doubtful_;
};

// The number in a cell: nan if the cell is empty; "nan", "inf" and numbers that overflow return values that are not
// finite. The other mark may separate groups of three digits. Nothing if the cell is not a number.
std::optional<double> cell_value(std::string_view cell, Decimal decimal);

} // namespace filum::stressfield
