// The result file of CalculiX (CalculiX GraphiX manual, "Result Format"): records with fixed columns, the kind in the
// first three or five. Blocks of nodes (2C), elements (3C) and results (100C), each ended by -3; 9999 ends the file.
#include "stressfield/formats.hpp"
#include "stressfield/frd_text.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace filum::stressfield {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
const double kNan = std::nan("");

// The shape of an element type of the file.
struct ElementKind {
    Shape shape;
    std::vector<std::uint8_t> order; // indices of its nodes in the order of Shape
};

// By the file's number. The file lists the upright edges of bricks and wedges before the upper ones.
const std::vector<ElementKind>& kinds() {
    static const std::vector<ElementKind> all = [] {
        const auto plain = [](Shape shape, std::uint8_t count) {
            ElementKind out{shape, {}};
            for (std::uint8_t k = 0; k < count; ++k) out.order.push_back(k);
            return out;
        };
        return std::vector<ElementKind>{
            {},
            plain(Shape::hex8, 8),
            plain(Shape::wedge6, 6),
            plain(Shape::tet4, 4),
            {Shape::hex20, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14, 15}},
            {Shape::wedge15, {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 13, 14, 9, 10, 11}},
            plain(Shape::tet10, 10),
            plain(Shape::triangle3, 3),
            plain(Shape::triangle6, 6),
            plain(Shape::quad4, 4),
            plain(Shape::quad8, 8),
            {Shape::tet4, {}}, // beams: unused, nodes are not read
            {Shape::tet4, {}},
        };
    }();
    return all;
}

// Maps numbers of nodes to indices.
class Numbering {
  public:
    void add(long long number) {
        if (number < 0 || (!numbers_.empty() && number <= numbers_.back())) sorted_ = false;
        numbers_.push_back(number);
    }
    // Sorts the numbers; false if one occurs twice.
    bool close() {
        order_.resize(numbers_.size());
        for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
        if (!sorted_)
            std::sort(order_.begin(), order_.end(), [&](auto a, auto b) { return numbers_[a] < numbers_[b]; });
        for (std::size_t i = 1; i < order_.size(); ++i)
            if (numbers_[order_[i - 1]] == numbers_[order_[i]]) return false;
        if (order_.empty()) return true;
        least_ = numbers_[order_.front()];
        const auto range = static_cast<std::uint64_t>(numbers_[order_.back()] - least_) + 1;
        if (range > 8 * numbers_.size()) return true;
        table_.assign(range, kNone);
        for (const auto i : order_) table_[static_cast<std::size_t>(numbers_[i] - least_)] = i;
        return true;
    }
    [[nodiscard]] std::uint32_t index(long long number) const {
        if (!table_.empty()) {
            const auto at = static_cast<std::uint64_t>(number - least_);
            return at < table_.size() ? table_[at] : kNone;
        }
        const auto found = std::lower_bound(order_.begin(), order_.end(), number,
                                            [&](std::uint32_t i, long long n) { return numbers_[i] < n; });
        return found != order_.end() && numbers_[*found] == number ? *found : kNone;
    }

  private:
    std::vector<long long> numbers_;
    std::vector<std::uint32_t> order_, table_;
    long long least_ = 0;
    bool sorted_ = true;
};

// A result with stresses. Its name is STEP-INCREMENT, or STEP-modeNUMBER for a mode.
struct StressResult {
    long long step = -1, increment = -1, mode = -1;
    double value = kNan;            // time, or frequency of a mode
    std::unique_ptr<Case> stresses; // null: skipped

    [[nodiscard]] std::string name() const {
        const std::string of = std::to_string(step);
        return mode >= 0 ? of + "-mode" + std::to_string(mode) : of + "-" + std::to_string(std::max(1LL, increment));
    }
    [[nodiscard]] std::string text() const {
        if (std::isnan(value)) return name();
        return name() + (mode >= 0 ? " (frequency " : " (time ") + shortest_text(value) + ")";
    }
};

class FrdReader {
  public:
    FrdReader(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes)
        : lines_(bytes), name_(name), notes_(notes), step_(options.step) {}

    Samples read() {
        bool ended = false;
        while (!ended && lines_.next(line_)) {
            const auto key = columns(line_, 0, 5);
            if (key == "    2")
                read_nodes();
            else if (key == "    3")
                read_elements();
            else if (line_.starts_with("    1PSTEP"))
                note_step();
            else if (line_.starts_with("    1PMODE"))
                note_mode();
            else if (key == "  100")
                read_result();
            else if (line_.starts_with(" 9999"))
                ended = true;
            else if (!known_to_be_of_no_use(key))
                fail("it is no record of an FRD file; are its columns moved?");
        }
        if (out_.points.empty()) bad(name_, "it has no nodes");
        if (!ended) notes_.push_back(note(NoteCode::frd_unended, 1));
        take_wanted();
        if (lost_ > 0) notes_.push_back(note(NoteCode::stress_not_finite, lost_));
        return std::move(out_);
    }

  private:
    // Whether the line is empty, a header, or of a block of another kind.
    bool known_to_be_of_no_use(std::string_view key) {
        long long number = 0;
        return line_.empty() || (key.size() == 5 && whole(key, number)) || line_.starts_with(" -");
    }

    // In the short form, numbers of nodes have five columns, otherwise ten; binary files are rejected.
    void use_format(std::string_view field) {
        long long format = 1;
        if (!field.empty() && !whole(field, format)) fail("its format is no number");
        if (format > 1 || format < 0)
            bad(name_,
                "it is binary; write it as text: *NODE FILE and *EL FILE instead of *NODE OUTPUT and *EL OUTPUT");
        id_ = format == 0 ? 5 : 10;
    }

    // Reads the next line of the block; false at its end.
    bool in_block(const char* what) {
        if (!lines_.next(line_)) cut(name_, std::string("it ends inside the ") + what);
        return !line_.starts_with(" -3");
    }

    long long id() {
        long long out = 0;
        if (!line_.starts_with(" -1") || !whole(columns(line_, 3, id_), out)) fail("it has no number in columns 4 on");
        return out;
    }

    void expect(std::string_view field, std::size_t found, const char* what) {
        long long announced = 0;
        if (whole(field, announced) && announced != static_cast<long long>(found))
            bad(name_, "it announces " + std::to_string(announced) + " " + what + " and has " + std::to_string(found));
    }

    void read_nodes() {
        if (!out_.points.empty()) fail("it begins a second block of nodes");
        const std::string_view header = line_;
        use_format(columns(header, 73, 2));
        out_.points.reserve(lines_.left() / 150); // estimated from the size of the file including results
        while (in_block("nodes")) {
            numbering_.add(id());
            double p[3];
            if (!numbers(line_, 3 + id_, 3, p)) fail("it does not hold three numbers of 12 columns");
            out_.points.push_back({p[0], p[1], p[2]});
            if (!std::isfinite(p[0] + p[1] + p[2])) fail("a coordinate is not finite");
        }
        expect(columns(header, 24, 12), out_.points.size(), "nodes");
        if (!numbering_.close()) bad(name_, "two nodes have one number");
    }

    void read_elements() {
        const std::string_view header = line_;
        use_format(columns(header, 73, 2));
        std::size_t count = 0;
        bool more = in_block("elements");
        for (; more; ++count) {
            id();
            long long type = 0;
            if (!whole(columns(line_, 3 + id_, 5), type)) fail("an element has no type");
            if (type < 1 || static_cast<std::size_t>(type) >= kinds().size())
                fail("an element is of the unknown type " + std::to_string(type));
            const ElementKind& kind = kinds()[static_cast<std::size_t>(type)];
            found_.clear();
            while ((more = in_block("elements")) && line_.starts_with(" -2"))
                for (std::size_t at = 3; at < line_.size(); at += id_) add_node(columns(line_, at, id_));
            if (!kind.order.empty()) add_element(kind);
        }
        expect(columns(header, 24, 12), count, "elements");
    }

    void add_node(std::string_view field) {
        long long number = 0;
        if (!whole(field, number)) fail("the number of a node is none");
        found_.push_back(numbering_.index(number));
        if (found_.back() == kNone) fail("an element has the node " + std::to_string(number) + ", which is not there");
    }

    void add_element(const ElementKind& kind) {
        if (found_.size() != kind.order.size())
            fail("the element before has " + std::to_string(found_.size()) + " nodes, not " +
                 std::to_string(kind.order.size()));
        out_.elements.push_back({kind.shape, static_cast<std::uint32_t>(out_.nodes.size())});
        for (const auto k : kind.order) out_.nodes.push_back(found_[k]);
    }

    // Reads "1PSTEP", a running number, the increment, the step.
    void note_step() {
        long long n = 0;
        if (whole(columns(line_, 48, 12), n)) next_.step = n;
        if (whole(columns(line_, 36, 12), n)) next_.increment = n;
    }

    // Reads "1PMODE", the number of a mode.
    void note_mode() {
        long long n = 0;
        if (whole(columns(line_, 24, 12), n)) next_.mode = n;
    }

    // Reads a result; its header has a time, or the frequency of a mode.
    void read_result() {
        use_format(columns(line_, 73, 2));
        StressResult own = std::exchange(next_, {});
        if (own.step < 0) whole(columns(line_, 58, 5), own.step);
        own.step = std::max(0LL, own.step);
        double value = 0;
        if (number(columns(line_, 12, 12), value)) own.value = value;
        if (!lines_.next(line_)) cut(name_, "it ends inside a result");
        if (!line_.starts_with(" -4")) fail("a result does not begin with -4");
        std::string_view what = columns(line_, 5, 8);
        what = what.substr(0, what.find(' '));
        if (what == "STRESS" && may_be_wanted(own)) {
            own.stresses = std::make_unique<Case>();
            read_stresses(*own.stresses);
        } else {
            if (!lines_.seek(" -3")) cut(name_, "it ends inside a result");
            lines_.next(line_);
        }
        if (what == "STRESS") add(std::move(own));
    }

    [[nodiscard]] bool may_be_wanted(const StressResult& r) const {
        return step_ == "all" || step_ == r.name() || step_ == std::to_string(r.step);
    }

    // Of the increments of a step only the last one is kept, unless --step names one.
    void add(StressResult r) {
        for (StressResult& other : results_) {
            const bool replaced = other.name() == r.name() || (other.step == r.step && other.mode < 0 && r.mode < 0 &&
                                                               other.name() != step_ && r.name() != step_);
            if (replaced) other.stresses.reset();
        }
        results_.push_back(std::move(r));
    }

    // Makes load cases of the results that --step selects: the last increment of a step and each of its modes, or one
    // result.
    void take_wanted() {
        if (results_.empty()) bad(name_, "it holds no STRESS; ask for S on *EL FILE");
        std::vector<std::string> unused;
        std::vector<long long> modes;
        for (StressResult& r : results_) {
            const bool by_step = step_ == std::to_string(r.step);
            if (!may_be_wanted(r)) continue;
            if (!r.stresses) {
                unused.push_back(r.name());
                continue;
            }
            if (by_step && r.mode >= 0) modes.push_back(r.mode);
            r.stresses->name = by_step || (step_ == "all" && r.mode < 0) ? std::to_string(r.step) : r.name();
            r.stresses->origin = "STRESS of step " + r.text();
            out_.cases.push_back(std::move(*r.stresses));
        }
        if (out_.cases.empty() || (modes.size() > 1 && step_ != "all"))
            throw Error(Exit::usage, "cannot use '" + step_ + "' for --step: " + name_ + " has the steps " + list());
        if (!unused.empty()) notes_.push_back(note(NoteCode::frd_result_superseded, unused.size(), joined(unused)));
    }

    static std::string joined(const std::vector<std::string>& names) {
        constexpr std::size_t kShown = 12; // of longer lists only the count is shown
        std::string out;
        for (std::size_t k = 0; k < names.size() && k < kShown; ++k) out += (k == 0 ? "" : ", ") + names[k];
        return names.size() > kShown ? out + " ... " + names.back() : out;
    }

    [[nodiscard]] std::string list() const {
        std::vector<std::string> names;
        for (const StressResult& r : results_) {
            const bool alone = r.mode < 0 && std::ranges::count(results_, r.step, &StressResult::step) == 1;
            names.push_back(alone ? std::to_string(r.step) : r.text());
        }
        return joined(names);
    }

    void read_stresses(Case& c) {
        static constexpr std::string_view kNames[] = {"SXX", "SYY", "SZZ", "SXY", "SYZ", "SZX"};
        c.tensors.assign(out_.points.size(), {kNan, kNan, kNan, kNan, kNan, kNan});
        std::size_t component = 0;
        while (in_block("stresses")) {
            if (line_.starts_with(" -5")) {
                if (component >= 6 || columns(line_, 5, 3) != kNames[component])
                    fail("a component of stress is not where SXX SYY SZZ SXY SYZ SZX has it");
                ++component;
                continue;
            }
            const long long number = id();
            const std::uint32_t i = numbering_.index(number);
            if (i == kNone) fail("a result is of the node " + std::to_string(number) + ", which is not there");
            Tensor& t = c.tensors[i];
            if (component != 6 || !numbers(line_, 3 + id_, 6, t.data()))
                fail("it does not hold six numbers of 12 columns");
            if (!std::isfinite(t[0] + t[1] + t[2] + t[3] + t[4] + t[5])) {
                t[0] = kNan;
                ++lost_;
            }
        }
    }

    [[noreturn]] void fail(const std::string& why) const {
        if (!lines_.ended()) cut(name_, "it ends inside line " + std::to_string(lines_.line()));
        bad(name_, "line " + std::to_string(lines_.line()) + ": " + why);
    }

    Lines lines_;
    const std::string& name_;
    Notes& notes_;
    std::string step_;
    std::string_view line_;
    Numbering numbering_;
    std::size_t id_ = 10;               // columns of node numbers
    StressResult next_;                 // properties of the next result from the records before it
    std::vector<std::uint32_t> found_;  // nodes of the current element
    std::vector<StressResult> results_; // with stresses, in the order of the file
    std::size_t lost_ = 0;
    Samples out_;
};

} // namespace

Samples read_frd(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes) {
    return FrdReader(bytes, name, options, notes).read();
}

} // namespace filum::stressfield
