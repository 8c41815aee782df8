#include "macro/regex.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <stdexcept>

namespace filum::macro {

namespace {

using Set = std::bitset<256>;
using Op = Regex::Op;
using Step = Regex::Step;

constexpr std::size_t kMostSteps = 20'000;
constexpr std::size_t kMostRepeats = 1'000;
constexpr int kDeepest = 100; // deepest nesting of groups

[[noreturn]] void fail(const std::string& why) { throw std::invalid_argument(why); }

Set of_class(int (*is)(int)) {
    Set out;
    for (int c = 0; c < 128; ++c) out[static_cast<std::size_t>(c)] = is(c) != 0;
    return out;
}

Set words() {
    Set out = of_class(std::isalnum);
    out.set('_');
    return out;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

} // namespace

// Compiles a pattern by recursive descent.  Every part is a run of steps that continues at its end.
class RegexCompiler {
  public:
    RegexCompiler(std::string_view pattern, Regex& out) : rest_(pattern), out_(out) {}

    void run() {
        alternatives(0);
        if (!rest_.empty()) fail("a ')' has no partner");
        out_.steps_.push_back({Op::done, 0, 0});
    }

  private:
    std::vector<Step>& steps() { return out_.steps_; }

    void push(Step step) {
        if (steps().size() >= kMostSteps) fail("the pattern repeats too often");
        steps().push_back(step);
    }

    bool take(char c) {
        if (rest_.empty() || rest_.front() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    // Compiles a|b: a split before and a jump after each alternative.
    void alternatives(int depth) {
        if (depth > kDeepest) fail("its groups are nested too deep");
        const std::size_t from = steps().size();
        std::vector<std::size_t> jumps;
        sequence(depth);
        while (take('|')) {
            insert(from, {Op::split, from + 1, steps().size() + 2});
            for (std::size_t& j : jumps) ++j;
            jumps.push_back(steps().size());
            push({Op::jump, 0, 0});
            sequence(depth);
        }
        for (const std::size_t j : jumps) steps()[j].a = steps().size();
    }

    // Inserts a step at `at`, and moves the targets of the steps after it.
    void insert(std::size_t at, Step step) {
        if (steps().size() >= kMostSteps) fail("the pattern repeats too often");
        for (std::size_t i = at; i < steps().size(); ++i) {
            Step& s = steps()[i];
            if (s.op == Op::split || s.op == Op::jump) {
                if (s.a >= at) ++s.a;
                if (s.op == Op::split && s.b >= at) ++s.b;
            }
        }
        steps().insert(steps().begin() + static_cast<std::ptrdiff_t>(at), step);
    }

    void sequence(int depth) {
        while (!rest_.empty() && rest_.front() != '|' && rest_.front() != ')') {
            const std::size_t from = steps().size();
            atom(depth);
            while (repeat(from)) {
            }
        }
    }

    void atom(int depth) {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        if (c == '(') {
            if (take('?') && !take(':')) fail("it has a look-around, which Filum does not know");
            alternatives(depth + 1);
            if (!take(')')) fail("a '(' has no partner");
        } else if (c == '[') {
            set(bracket());
        } else if (c == '.') {
            set(Set().set());
        } else if (c == '^' || c == '$') {
            push({c == '^' ? Op::begin : Op::end, 0, 0});
        } else if (c == '*' || c == '+' || c == '?') {
            fail(std::string("nothing stands before '") + c + "'");
        } else if (c == '\\') {
            if (rest_.empty()) fail("it ends with a backslash");
            if (rest_.front() == 'b' || rest_.front() == 'B') {
                push({rest_.front() == 'b' ? Op::boundary : Op::no_boundary, 0, 0});
                rest_.remove_prefix(1);
            } else {
                set(escaped());
            }
        } else {
            set(Set().set(static_cast<unsigned char>(c)));
        }
    }

    void set(const Set& set) {
        push({Op::set, out_.sets_.size(), 0});
        out_.sets_.push_back(set);
    }

    // The set of characters that an escape after a backslash matches.
    Set escaped() {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        switch (c) {
        case 'd':
            return of_class(std::isdigit);
        case 'D':
            return ~of_class(std::isdigit);
        case 's':
            return of_class(std::isspace);
        case 'S':
            return ~of_class(std::isspace);
        case 'w':
            return words();
        case 'W':
            return ~words();
        case 'n':
            return Set().set('\n');
        case 'r':
            return Set().set('\r');
        case 't':
            return Set().set('\t');
        default:
            break;
        }
        if (c >= '1' && c <= '9') fail("it has a back-reference, which Filum does not know");
        return Set().set(static_cast<unsigned char>(c));
    }

    Set bracket() {
        const bool inverse = take('^');
        Set out;
        bool first = true;
        for (;; first = false) {
            if (rest_.empty()) fail("a '[' has no partner");
            if (!first && take(']')) break;
            const Set one = bracket_item();
            const bool range = rest_.size() > 1 && rest_[0] == '-' && rest_[1] != ']' && one.count() == 1;
            if (!range) {
                out |= one;
                continue;
            }
            rest_.remove_prefix(1);
            const Set to = bracket_item();
            const std::size_t low = one._Find_first(), high = to._Find_first();
            if (to.count() != 1 || high < low) fail("a range in '[...]' has no order");
            for (std::size_t i = low; i <= high; ++i) out.set(i);
        }
        return inverse ? ~out : out;
    }

    Set bracket_item() {
        const char c = rest_.front();
        rest_.remove_prefix(1);
        if (c != '\\') return Set().set(static_cast<unsigned char>(c));
        if (rest_.empty()) fail("it ends with a backslash");
        return escaped();
    }

    std::optional<std::size_t> number() {
        std::size_t out = 0, digits = 0;
        for (; !rest_.empty() && std::isdigit(static_cast<unsigned char>(rest_.front())) != 0; ++digits) {
            out = std::min(out * 10 + static_cast<std::size_t>(rest_.front() - '0'), kMostRepeats + 1);
            rest_.remove_prefix(1);
        }
        return digits > 0 ? std::optional(out) : std::nullopt;
    }

    // Applies a repeat (* + ? {n,m}) to the part that starts at `from`.  False if none follows.
    bool repeat(std::size_t from) {
        if (rest_.empty()) return false;
        if (take('*')) {
            star(from);
        } else if (take('+')) {
            const std::size_t end = steps().size();
            push({Op::split, from, end + 1});
        } else if (take('?')) {
            insert(from, {Op::split, from + 1, steps().size() + 1});
        } else if (take('{')) {
            counted(from);
        } else {
            return false;
        }
        (void)take('?'); // lazy or greedy does not matter for a match of the whole text
        return true;
    }

    void star(std::size_t from) {
        insert(from, {Op::split, from + 1, steps().size() + 2});
        push({Op::jump, from, 0});
    }

    // Appends another copy of a part's steps.
    void copy(const std::vector<Step>& part, std::size_t from) {
        const std::size_t by = steps().size() - from;
        for (Step s : part) {
            if (s.op == Op::split || s.op == Op::jump) s.a += by;
            if (s.op == Op::split) s.b += by;
            push(s);
        }
    }

    void counted(std::size_t from) {
        const auto least = number();
        std::optional<std::size_t> most = least;
        if (take(',')) most = number();
        if (!take('}') || !least || *least > kMostRepeats || most.value_or(0) > kMostRepeats ||
            (most && *most < *least))
            fail("'{' begins no count");
        const std::vector<Step> part(steps().begin() + static_cast<std::ptrdiff_t>(from), steps().end());
        steps().resize(from);
        for (std::size_t i = 0; i < *least; ++i) copy(part, from);
        if (!most) {
            const std::size_t at = steps().size();
            copy(part, from);
            star(at);
            return;
        }
        for (std::size_t i = *least; i < *most; ++i) {
            const std::size_t at = steps().size();
            copy(part, from);
            insert(at, {Op::split, at + 1, steps().size() + 1});
        }
    }

    std::string_view rest_;
    Regex& out_;
};

Regex::Regex(std::string_view pattern) { RegexCompiler(pattern, *this).run(); }

namespace {

// Follows all paths through the steps at the same time, so that the time is bounded.
class Matcher {
  public:
    Matcher(const std::vector<Step>& steps, std::string_view text)
        : steps_(steps), text_(text), seen_(steps.size(), 0) {}

    // Adds the steps that are reached from `step` without consuming a character, before text_[at].
    void add(std::size_t step, std::size_t at, std::vector<std::size_t>& to) {
        const std::size_t mark = at + 1;
        todo_.assign(1, step);
        while (!todo_.empty()) {
            const std::size_t s = todo_.back();
            todo_.pop_back();
            if (seen_[s] == mark) continue;
            seen_[s] = mark;
            const Step& here = steps_[s];
            if (here.op == Op::split) todo_.push_back(here.b);
            if (here.op == Op::split || here.op == Op::jump)
                todo_.push_back(here.a);
            else if (here.op == Op::set || here.op == Op::done)
                to.push_back(s);
            else if (holds(here.op, at))
                todo_.push_back(s + 1);
        }
    }

  private:
    [[nodiscard]] bool holds(Op op, std::size_t at) const {
        if (op == Op::begin) return at == 0;
        if (op == Op::end) return at == text_.size();
        const bool before = at > 0 && is_word(text_[at - 1]), behind = at < text_.size() && is_word(text_[at]);
        return (before != behind) == (op == Op::boundary);
    }

    const std::vector<Step>& steps_;
    std::string_view text_;
    std::vector<std::size_t> seen_, todo_;
};

} // namespace

bool Regex::matches(std::string_view text) const {
    Matcher matcher(steps_, text);
    std::vector<std::size_t> now, next;
    matcher.add(0, 0, now);
    for (std::size_t i = 0; i < text.size() && !now.empty(); ++i) {
        next.clear();
        for (const std::size_t s : now)
            if (steps_[s].op == Op::set && sets_[steps_[s].a][static_cast<unsigned char>(text[i])])
                matcher.add(s + 1, i + 1, next);
        std::swap(now, next);
    }
    return std::ranges::any_of(now, [&](std::size_t s) { return steps_[s].op == Op::done; });
}

} // namespace filum::macro
