// Tables of numbers: separated by semicolons (then a comma is a decimal point), tabs, commas or blanks, whichever of
// these comes first in that order on a line; '#' begins a comment.  The line before the first one of numbers is a
// header.
#include "stressfield/csv_columns.hpp"
#include "stressfield/formats.hpp"
#include "stressfield/principal.hpp"

#include <charconv>
#include <span>

namespace filum::stressfield {

namespace {

using Cells = std::vector<std::string_view>;

std::string_view without_quotes(std::string_view t) {
    const auto from = t.find_first_not_of(" \t\r\"");
    if (from == std::string_view::npos) return {};
    return t.substr(from, t.find_last_not_of(" \t\r\"") + 1 - from);
}

char separator(std::string_view line) {
    for (const char c : {';', '\t', ','})
        if (line.find(c) != std::string_view::npos) return c;
    return ' ';
}

// Whole words of a line; an empty one behind the last separator is none.
void split(std::string_view line, char mark, Cells& out) {
    out.clear();
    for (std::size_t from = 0; from <= line.size();) {
        const std::size_t end = std::min(line.find(mark, from), line.size());
        const auto cell = without_quotes(line.substr(from, end - from));
        if (!cell.empty() || (mark != ' ' && end < line.size())) out.push_back(cell);
        from = end + 1;
    }
}

// "nan", "inf" and what overflows are numbers, not finite ones; so is an empty cell.
bool cell_value(std::string_view cell, bool decimal_comma, double& value) {
    value = std::nan("");
    if (cell.empty()) return true;
    if (cell.front() == '+') cell.remove_prefix(1);
    std::string dotted;
    if (decimal_comma && cell.find(',') != std::string_view::npos) {
        dotted = cell;
        dotted[dotted.find(',')] = '.';
        cell = dotted;
    }
    const char* const end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, value);
    return error != std::errc::invalid_argument && stop == end;
}

class Table {
  public:
    Table(std::string_view bytes, const std::string& name, const std::string& columns, Notes& notes)
        : rest_(bytes), name_(name), notes_(notes), given_(!columns.empty()) {
        if (given_) columns_ = columns_of_option(columns);
        if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3); // byte order mark
    }

    Samples read() {
        Cells header;
        std::vector<double> row;
        std::size_t not_finite = 0;
        while (next_line()) {
            const bool numbers = parse(row);
            if (width_ == 0 && !numbers) {
                header = cells_;
                continue;
            }
            if (width_ == 0) begin(header);
            if (!numbers) fail("'" + std::string(culprit_.substr(0, 20)) + "' is no number");
            if (row.size() != width_)
                fail("it has " + std::to_string(row.size()) + " columns, the first one " + std::to_string(width_));
            if (!add(row)) ++not_finite;
        }
        if (width_ == 0) bad(name_, "it is no table of numbers, FRD or VTU file");
        if (not_finite > 0) notes_.push_back(note("sample that is not finite left out", not_finite));
        if (out_.points.empty()) bad(name_, "it holds no sample");
        finish();
        return std::move(out_);
    }

  private:
    // The next line that is neither empty nor a comment.
    bool next_line() {
        while (!rest_.empty()) {
            ++line_number_;
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            last_ = end == rest_.size();
            std::string_view line = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            line = without_quotes(line.substr(0, line.find('#')));
            if (line.empty()) continue;
            if (width_ == 0) mark_ = separator(line);
            split(line, mark_, cells_);
            return true;
        }
        return false;
    }

    // The cells as numbers; false, with a culprit, if one is none.
    bool parse(std::vector<double>& row) {
        row.resize(cells_.size());
        for (std::size_t i = 0; i < cells_.size(); ++i)
            if (!cell_value(cells_[i], mark_ == ';' || mark_ == '\t', row[i])) {
                culprit_ = cells_[i];
                return false;
            }
        return true;
    }

    void begin(const Cells& header) {
        width_ = cells_.size();
        if (!given_) columns_ = header.empty() ? columns_of_count(width_) : columns_of_header(header);
        if (const std::string what = missing(columns_); !what.empty())
            bad(name_, "there is no " + what + " among " + std::to_string(width_) + " columns; name them by --columns");
        for (const std::size_t c : columns_)
            if (c != kNoColumn && c >= width_)
                bad(name_, std::string(given_ ? "--columns" : "the header") + " names " + std::to_string(c + 1) +
                               " columns, line " + std::to_string(line_number_) + " has " + std::to_string(width_));
        tensors_ = has_tensor(columns_);
        out_.cases.push_back({"1", {}, {}, {}});
    }

    // False if it is not finite.
    bool add(const std::vector<double>& row) {
        const auto at = [&](std::size_t role, double other) {
            return columns_[role] == kNoColumn ? other : row[columns_[role]];
        };
        const double unknown = std::numeric_limits<double>::infinity();
        const Vec3 p{row[columns_[kX]], row[columns_[kY]], row[columns_[kZ]]};
        if (!std::isfinite(p.x + p.y + p.z)) return false;
        Case& c = out_.cases[0];
        if (tensors_) {
            Tensor t;
            for (std::size_t k = 0; k < 6; ++k) t[k] = row[columns_[kXx + k]];
            if (!std::isfinite(t[0] + t[1] + t[2] + t[3] + t[4] + t[5])) return false;
            c.tensors.push_back(t);
        } else {
            const Vec3 d{row[columns_[kVx]], row[columns_[kVy]], row[columns_[kVz]]};
            const Principal s{at(kS1, norm(d)), at(kS2, unknown), at(kS3, unknown)};
            if (!std::isfinite(norm(d) + s[0]) || std::isnan(s[1] + s[2])) return false;
            c.directions.push_back(d);
            c.principals.push_back(s);
        }
        out_.points.push_back(p);
        return true;
    }

    // Samples at one place, as of a node in several elements, become their mean.
    void finish() {
        std::vector<std::uint32_t> order(out_.points.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto key = [&](std::uint32_t i) {
            const Vec3& p = out_.points[i];
            return std::array{p.x, p.y, p.z};
        };
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
        Samples merged;
        merged.cases.push_back({out_.cases[0].name, {}, {}, {}});
        for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
            for (j = i; j < order.size() && key(order[j]) == key(order[i]);) ++j;
            merged.points.push_back(out_.points[order[i]]);
            add_mean(std::span(order).subspan(i, j - i), out_.cases[0], merged.cases[0]);
        }
        if (const std::size_t less = out_.points.size() - merged.points.size(); less > 0)
            notes_.push_back(note("sample averaged with another at its place", less));
        out_ = std::move(merged);
    }

    static void add_mean(std::span<const std::uint32_t> of, const Case& from, Case& to) {
        const double share = 1 / static_cast<double>(of.size());
        Tensor t{};
        Principal s{};
        for (const auto i : of) {
            const Tensor own = from.tensors.empty() ? about(from.directions[i], from.principals[i]) : from.tensors[i];
            for (std::size_t k = 0; k < 6; ++k) t[k] += share * own[k];
            for (std::size_t k = 0; from.tensors.empty() && k < 3; ++k) s[k] += share * from.principals[i][k];
        }
        if (!from.tensors.empty()) {
            to.tensors.push_back(t);
            return;
        }
        to.principals.push_back(s);
        to.directions.push_back(of.size() == 1 ? from.directions[of[0]] : principal_axes(t).first.value_or(Vec3{}));
    }

    [[noreturn]] void fail(const std::string& why) const {
        if (last_) cut(name_, "it ends inside line " + std::to_string(line_number_));
        bad(name_, "line " + std::to_string(line_number_) + ": " + why);
    }

    std::string_view rest_;
    const std::string& name_;
    Notes& notes_;
    bool given_;
    Columns columns_{};
    Cells cells_;
    char mark_ = ' ';
    std::string_view culprit_;
    std::size_t width_ = 0, line_number_ = 0;
    bool last_ = false, tensors_ = false;
    Samples out_;
};

} // namespace

Samples read_csv(std::string_view bytes, const std::string& name, const std::string& columns, Notes& notes) {
    return Table(bytes, name, columns, notes).read();
}

} // namespace filum::stressfield
