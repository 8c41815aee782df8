// Tables with one line per point; '#' and '%' begin comments. A header names the columns: the first line whose names
// include positions and stresses, or the last one before numbers, which may be in a comment.
#include "stressfield/csv_columns.hpp"
#include "stressfield/csv_text.hpp"
#include "stressfield/formats.hpp"
#include "stressfield/principal.hpp"
#include "stressfield/units.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace filum::stressfield {

namespace {

class CsvReader {
  public:
    CsvReader(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes)
        : bytes_(bytes), name_(name), options_(options), notes_(notes), given_(!options.columns.empty()), lines_("") {
        if (bytes_.starts_with("\xef\xbb\xbf")) bytes_.remove_prefix(3); // byte order mark
        if (given_) columns_ = columns_of_option(options.columns);
        lines_ = TextLines(bytes_);
    }

    Samples read() {
        find_header();
        decide_decimal();
        find_units();
        out_.cases.push_back({"1", {}, {}, {}, origin(), stress_unit_named_});
        std::size_t not_finite = 0;
        for_rows([&] { not_finite += add() ? 0 : 1; });
        if (not_finite > 0) notes_.push_back(note(NoteCode::sample_not_finite, not_finite));
        if (out_.points.empty()) bad(name_, "it holds no sample");
        finish();
        return std::move(out_);
    }

  private:
    // The next line that is not empty and not a comment; the last comment is kept as a possible header.
    bool next_line(std::string_view& line) {
        while (lines_.next(line)) {
            const std::size_t mark = line.find_first_of("#%");
            const bool whole = mark == 0;
            if (whole) comment_ = line.substr(std::min(line.find_first_not_of("#% "), line.size()));
            if (mark != line.npos && (whole || (line[mark] == '#' && line[mark - 1] == ' ')))
                line = line.substr(0, mark);
            while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
            if (!line.empty()) return true;
        }
        return false;
    }

    // Reads up to the first row, and determines the columns.
    void find_header() {
        std::string_view line, last_words;
        while (next_line(line)) {
            if (lines_.number() == 1 && line.size() == 5 && line.starts_with("sep=")) continue; // of spreadsheets
            mark_ = separator(line);
            split(line, mark_, cells_);
            std::string doubt;
            if (!given_ && missing(columns_of_header(cells_, doubt)).empty()) return use_header();
            if (!is_row()) {
                last_words = line;
                continue;
            }
            first_row_ = lines_.number();
            return begin_with_row(last_words);
        }
        if (!given_ && !last_words.empty()) {
            split(last_words, separator(last_words), cells_);
            std::string doubt;
            if (const Columns c = columns_of_header(cells_, doubt); has_position(c))
                bad(name_, "there is no " + missing(c) + " among its columns; name them by --columns");
        }
        bad(name_, "it is no table of numbers, FRD or VTU file");
    }

    // Whether all cells, or those of --columns, are numbers.
    [[nodiscard]] bool is_row() const {
        const auto number = [&](std::string_view cell) {
            return cell_value(cell, Decimal::point) || cell_value(cell, Decimal::comma);
        };
        if (!given_) return std::all_of(cells_.begin(), cells_.end(), number);
        return std::all_of(columns_.begin(), columns_.end(),
                           [&](std::size_t c) { return c == kNoColumn || (c < cells_.size() && number(cells_[c])); }) ||
               std::all_of(cells_.begin(), cells_.end(), number);
    }

    void use_header() {
        header_ = cells_;
        width_ = header_.size();
        std::string doubt;
        columns_ = columns_of_header(header_, doubt);
        if (!doubt.empty()) bad(name_, doubt + "; name them by --columns");
        header_line_ = lines_.number();
        first_row_ = header_line_ + 1;
    }

    // Handles a row of numbers before a complete header.
    void begin_with_row(std::string_view words) {
        width_ = cells_.size();
        const Cells row = cells_;
        for (const std::string_view text : {comment_, words}) {
            Cells names;
            split(text, separator(text), names);
            if (names.size() != width_ && separator(text) == ' ') split_wide(text, names);
            std::string doubt;
            const bool is_header =
                text == words && !words.empty() ? true : has_position(columns_of_header(names, doubt));
            if (is_header && (names.size() == width_ || text == words)) header_ = names;
        }
        if (!given_) {
            std::string doubt;
            columns_ = header_.empty() ? columns_of_count(width_) : columns_of_header(header_, doubt);
            if (const std::string what = missing(columns_); !what.empty())
                bad(name_,
                    "there is no " + what + " among " + std::to_string(width_) + " columns; name them by --columns");
            if (!doubt.empty()) bad(name_, doubt + "; name them by --columns");
            if (!header_.empty() && header_.size() != width_) wrong_width(first_row_, width_, header_.size());
        }
        for (const std::size_t c : columns_)
            if (c != kNoColumn && c >= width_)
                bad(name_, "--columns names " + std::to_string(c + 1) + " columns, line " + std::to_string(first_row_) +
                               " has " + std::to_string(width_));
        if (header_.size() != width_) header_.clear();
    }

    // Calls `use` for every row, with its cells in cells_.
    template <class Use>
    void for_rows(const Use& use) {
        lines_ = TextLines(bytes_);
        std::string_view line;
        while (next_line(line)) {
            if (lines_.number() < first_row_) continue;
            split(line, mark_, cells_);
            if (is_units_row() || cells_ == header_) continue; // the header may be repeated before each part
            if (cells_.size() != width_) {
                if (!lines_.ended() && cells_.size() < width_) cut_inside();
                wrong_width(lines_.number(), cells_.size(), width_);
            }
            use();
        }
    }

    // Whether the line is below the header and has units instead of numbers.
    bool is_units_row() {
        if (header_line_ == 0 || lines_.number() != header_line_ + 1 || cells_.size() != width_) return false;
        bool any = false;
        for (std::size_t r = 0; r < kRoles; ++r) {
            if (!is_used(columns_, r)) continue;
            std::string_view cell = cells_[columns_[r]];
            if (cell.size() > 1 && (cell.front() == '[' || cell.front() == '(')) cell = cell.substr(1, cell.size() - 2);
            if (cell.empty() || cell == "-") continue;
            if (!factor_of(dimension_of(r), cell)) return false;
            any = true;
            unit_texts_[r] = cell;
        }
        return any;
    }

    [[noreturn]] void wrong_width(std::size_t line, std::size_t has, std::size_t should) const {
        bad(name_, "line " + std::to_string(line) + ": it has " + std::to_string(has) + " columns, the " +
                       (header_.empty() ? "first one " : "header ") + std::to_string(should) +
                       (mark_ == ',' && has >= 2 * should ? "; are there decimal commas without quotes?" : ""));
    }

    [[noreturn]] void cut_inside() const { cut(name_, "it ends inside line " + std::to_string(lines_.number())); }

    // Determines the decimal mark from all used cells, and checks that rows belong to one load case.
    void decide_decimal() {
        DecimalEvidence evidence;
        std::vector<std::size_t> tellers;
        for (std::size_t k = 0; k < header_.size(); ++k)
            if (tells_cases(header_[k]) && std::find(columns_.begin(), columns_.end(), k) == columns_.end())
                tellers.push_back(k);
        Cells first;
        for_rows([&] {
            for (std::size_t r = 0; r < kRoles; ++r)
                if (is_used(columns_, r)) evidence.add(cells_[columns_[r]]);
            if (first.empty()) first = cells_;
            for (const std::size_t k : tellers)
                if (cells_[k] != first[k])
                    bad(name_, "its column '" + std::string(header_[k]) + "' has '" + std::string(first[k]) +
                                   "' and '" + std::string(cells_[k]) +
                                   "': it holds several load cases; keep the lines of one of them");
        });
        if (options_.decimal != "auto") {
            decimal_ = options_.decimal == "comma" ? Decimal::comma : Decimal::point;
            return;
        }
        if (evidence.comma() && evidence.point())
            bad(name_, "some of its numbers have a decimal comma, others a decimal point; give --decimal");
        if (!evidence.doubtful().empty() && !evidence.comma() && !evidence.point() && mark_ != ';')
            bad(name_, "its number '" + evidence.doubtful() +
                           "' may have a decimal comma or thousands set apart; give --decimal");
        const bool semicolons = mark_ == ';' && !evidence.doubtful().empty() && !evidence.point();
        decimal_ = evidence.comma() || semicolons ? Decimal::comma : Decimal::point;
    }

    // With --columns the header may consist of units only.
    static std::string unit_of(Dimension dimension, std::string_view name) {
        return factor_of(dimension, name) ? std::string(name) : unit_in(dimension, name);
    }

    static Dimension dimension_of(std::size_t role) { return role <= kZ ? Dimension::length : Dimension::stress; }

    // Sets the factors of all used columns, from --unit and --stress-unit, otherwise from the header, otherwise 1.
    void find_units() {
        for (const auto dimension : {Dimension::length, Dimension::stress}) find_units(dimension);
    }

    void find_units(Dimension dimension) {
        const bool length = dimension == Dimension::length;
        const std::string& option = length ? options_.unit : options_.stress_unit;
        const std::string flag = length ? "--unit" : "--stress-unit";
        std::string& common = length ? length_unit_ : stress_unit_;
        std::string unused;
        std::size_t without = 0, used = 0;
        for (std::size_t r = 0; r < kRoles; ++r) {
            if (!is_used(columns_, r) || dimension_of(r) != dimension) continue;
            std::string own = unit_texts_[r];
            if (own.empty() && !header_.empty()) own = unit_of(dimension, header_[columns_[r]]);
            ++used;
            without += own.empty() ? 1 : 0;
            const auto factor = factor_of(dimension, own);
            if (option != "auto") {
                factor_[r] = *factor_of(dimension, option);
                if (factor && *factor != factor_[r]) unused = own;
                continue;
            }
            if (own.empty()) continue;
            if (!length) stress_unit_named_ = true;
            if (!factor)
                bad(name_,
                    std::string("the unit '").append(own).append("' in its header is not known; give ").append(flag));
            factor_[r] = *factor;
            if (common.empty()) common = own;
            if (*factor != factor_of(dimension, common)) mixed_ = true;
        }
        if (!unused.empty()) notes_.push_back(note(NoteCode::header_unit_ignored, 1, unused));
        if (without > 0 && without < used && option == "auto") {
            if (mixed_) bad(name_, "its columns have several units, and some have none; give " + flag);
            for (std::size_t r = 0; r < kRoles; ++r)
                if (is_used(columns_, r) && dimension_of(r) == dimension) factor_[r] = *factor_of(dimension, common);
        }
        if (option != "auto") common = option;
        if (common.empty()) common = length ? "mm" : "MPa";
    }

    // The description of the input for the history of the stream.
    [[nodiscard]] std::string origin() const {
        std::string names;
        for (std::size_t r = 0; r < kRoles; ++r) {
            if (!is_used(columns_, r)) continue;
            const bool by_name = !given_ && !header_.empty();
            names += (names.empty() ? "" : " ") +
                     (by_name ? std::string(header_[columns_[r]]) : "column " + std::to_string(columns_[r] + 1));
        }
        return names + " as x y z " + (has_tensor(columns_) ? "xx yy zz xy yz zx" : "and vector") + ", " +
               length_unit_ + ", " + stress_unit_;
    }

    [[nodiscard]] double value(std::size_t role) const {
        const auto v = cell_value(cells_[columns_[role]], decimal_);
        if (!v) {
            if (!lines_.ended()) cut_inside();
            bad(name_, "line " + std::to_string(lines_.number()) + ": '" +
                           std::string(cells_[columns_[role]].substr(0, 20)) + "' is no number");
        }
        return *v * factor_[role];
    }

    // Adds the row; false if it is not finite.
    bool add() {
        std::array<double, kRoles> v{};
        for (std::size_t r = 0; r < kRoles; ++r)
            if (is_used(columns_, r)) v[r] = value(r);
        const auto at = [&](std::size_t role, double other) { return is_used(columns_, role) ? v[role] : other; };
        const double unknown = std::numeric_limits<double>::infinity();
        if (!std::isfinite(v[kX] + v[kY] + v[kZ])) return false;
        Case& c = out_.cases[0];
        if (has_tensor(columns_)) {
            Tensor t;
            for (std::size_t k = 0; k < 6; ++k) t[k] = v[kXx + k];
            if (!std::isfinite(t[0] + t[1] + t[2] + t[3] + t[4] + t[5])) return false;
            c.tensors.push_back(t);
        } else {
            const Vec3 d{v[kVx], v[kVy], v[kVz]};
            const Principal s{at(kS1, norm(d)), at(kS2, unknown), at(kS3, unknown)};
            if (!std::isfinite(norm(d) + s[0]) || std::isnan(s[1] + s[2])) return false;
            check_order(s);
            c.directions.push_back(d);
            c.principals.push_back(s);
        }
        out_.points.push_back({v[kX], v[kY], v[kZ]});
        return true;
    }

    // s1 is the greatest; with the opposite order the vector would be the direction of the least.
    void check_order(const Principal& s) const {
        // fraction of the largest: more than the rounding error of four digits of text
        constexpr double kRounding = 1e-3;
        for (std::size_t k = 1; k < 3; ++k)
            if (std::isfinite(s[k]) && s[k] - s[0] > kRounding * std::max(std::abs(s[k]), std::abs(s[0])))
                bad(name_, "line " + std::to_string(lines_.number()) + ": s" + std::to_string(k + 1) +
                               " is greater than s1, which should be the greatest; name columns by --columns");
    }

    // Averages samples at the same place, as of a node in several elements.
    void finish() {
        std::vector<std::uint32_t> order(out_.points.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto key = [&](std::uint32_t i) {
            const Vec3& p = out_.points[i];
            return std::array{p.x, p.y, p.z};
        };
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
        refuse_repetition(order);
        Samples merged;
        merged.cases.push_back({out_.cases[0].name, {}, {}, {}, out_.cases[0].origin, out_.cases[0].unit_named});
        for (std::size_t i = 0, j = 0; i < order.size(); i = j) {
            for (j = i; j < order.size() && key(order[j]) == key(order[i]);) ++j;
            merged.points.push_back(out_.points[order[i]]);
            add_mean(std::span(order).subspan(i, j - i), out_.cases[0], merged.cases[0]);
        }
        if (const std::size_t less = out_.points.size() - merged.points.size(); less > 0)
            notes_.push_back(note(NoteCode::sample_averaged, less));
        out_ = std::move(merged);
    }

    // Refuses a table that lists all places again in the same order with other stresses, as tables of several load
    // cases do. The corners of elements come in another order. `order` has the points sorted by place.
    void refuse_repetition(const std::vector<std::uint32_t>& order) const {
        const auto& points = out_.points;
        const std::size_t n = points.size();
        std::size_t times = 1; // of the first place
        while (times < n && points[order[times]] == points[order[0]]) ++times;
        if (times < 2 || n % times != 0) return;
        const std::size_t once = n / times;
        for (std::size_t i = 0; i < n; ++i) // `once` different places follow each other again and again
            if (order[i] % once != order[i - i % times] % once || points[i] != points[i % once]) return;
        const Case& c = out_.cases[0];
        const auto differ = [&](std::size_t i, std::size_t k) {
            return c.tensors.empty() ? c.directions[i] != c.directions[k] || c.principals[i] != c.principals[k]
                                     : c.tensors[i] != c.tensors[k];
        };
        for (std::size_t i = 0; i + once < n; ++i)
            if (differ(i, i + once))
                bad(name_, "it lists the same " + std::to_string(once) + " places " + std::to_string(times) +
                               " times, with different stresses: it holds several load cases; keep the lines of one of "
                               "them");
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

    std::string_view bytes_;
    const std::string& name_;
    const ReadOptions& options_;
    Notes& notes_;
    bool given_, mixed_ = false, stress_unit_named_ = false;
    Columns columns_{};
    TextLines lines_;
    std::string_view comment_; // the last comment before numbers
    Cells header_, cells_;
    char mark_ = ' ';
    std::size_t width_ = 0, header_line_ = 0, first_row_ = 0;
    Decimal decimal_ = Decimal::point;
    std::array<std::string, kRoles> unit_texts_; // from a line of units
    std::array<double, kRoles> factor_ = [] {
        std::array<double, kRoles> out{};
        out.fill(1);
        return out;
    }();
    std::string length_unit_, stress_unit_;
    Samples out_;
};

} // namespace

Samples read_csv(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes) {
    return CsvReader(bytes, name, options, notes).read();
}

} // namespace filum::stressfield
