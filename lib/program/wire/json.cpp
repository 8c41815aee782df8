#include "wire/json.hpp"

#include "base/utf8.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace filum::wire {

namespace {

constexpr int kDeepest = 64; // most brackets within each other

struct Fault {}; // the text is no JSON

// Joins the items of a list.  A comma is between them; if an item holds a comma, a quote or a line end, the items are
// in quotes with semicolons between them, as PrusaSlicer writes lists of texts.
std::string joined(const std::vector<std::string>& items) {
    const bool quoted = items.size() > 1 && std::ranges::any_of(items, [](const std::string& item) {
                            return item.find_first_of(",\"\n") != std::string::npos;
                        });
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (i > 0) out += quoted ? ';' : ',';
        if (!quoted) {
            out += items[i];
            continue;
        }
        out += '"';
        for (const char c : items[i]) {
            if (c == '"' || c == '\\' || c == '\n') out += '\\';
            out += c == '\n' ? 'n' : c;
        }
        out += '"';
    }
    return out;
}

// Parses JSON.  As in most readers of JSON, the last one of several equal names counts.  Throws Fault.
class Parser {
  public:
    explicit Parser(std::string_view text) : rest_(text) {}

    std::map<std::string, std::string> object() {
        std::map<std::string, std::string> out;
        members([&](std::string name, std::string value) { out[std::move(name)] = std::move(value); });
        blanks();
        if (!rest_.empty()) throw Fault{};
        return out;
    }

    // The values of the object and of those within it, by path.
    std::map<std::string, std::string> leaves() {
        leaves_.emplace();
        (void)object();
        return *std::move(leaves_);
    }

  private:
    // Adds a name to the path, and removes it again.
    class Within {
      public:
        Within(Parser& parser, const std::string& name) : path_(parser.path_), before_(parser.path_.size()) {
            path_ += (path_.empty() ? "" : "/") + name;
        }
        ~Within() { path_.resize(before_); }
        Within(const Within&) = delete;
        Within& operator=(const Within&) = delete;

      private:
        std::string& path_;
        std::size_t before_;
    };

    template <class Use>
    void members(Use use) {
        take('{');
        if (takes('}')) return;
        do {
            std::string name = text();
            take(':');
            const Within inside(*this, name);
            use(std::move(name), value());
        } while (takes(','));
        take('}');
    }

    std::string value() {
        blanks();
        if (rest_.empty() || ++depth_ > kDeepest) throw Fault{};
        std::string out;
        const bool object = rest_[0] == '{';
        if (object)
            members([](const std::string&, const std::string&) {});
        else if (rest_[0] == '[')
            out = joined(list());
        else
            out = rest_[0] == '"' ? text() : plain();
        if (leaves_ && !object) (*leaves_)[path_] = out;
        --depth_;
        return out;
    }

    std::vector<std::string> list() {
        std::vector<std::string> out;
        take('[');
        if (takes(']')) return out;
        do {
            const Within inside(*this, std::to_string(out.size()));
            out.push_back(value());
        } while (takes(','));
        take(']');
        return out;
    }

    // A number, true, false or null.
    std::string plain() {
        for (const auto& [word, means] : {std::pair{"true", "1"}, std::pair{"false", "0"}, std::pair{"null", ""}})
            if (rest_.starts_with(word)) {
                rest_.remove_prefix(std::string_view(word).size());
                return means;
            }
        double number = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
        if (error != std::errc() || (rest_[0] != '-' && (rest_[0] < '0' || rest_[0] > '9'))) throw Fault{};
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return shortest_text(number);
    }

    std::string text() {
        take('"');
        std::string out;
        while (!rest_.empty() && rest_[0] != '"') {
            const char c = next();
            if (c == '\\')
                escaped(out);
            else
                out += c;
        }
        take('"');
        return out;
    }

    void escaped(std::string& to) {
        const char c = next();
        constexpr std::string_view letters = "bfnrt", means = "\b\f\n\r\t";
        if (c == 'u') {
            std::uint32_t code = four_digits();
            if (code >= 0xd800 && code < 0xdc00) { // the first half of a pair
                if (next() != '\\' || next() != 'u') throw Fault{};
                const std::uint32_t low = four_digits();
                if (low < 0xdc00 || low > 0xdfff) throw Fault{};
                code = 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00);
            }
            append_utf8(code, to);
        } else if (const auto at = letters.find(c); at != std::string_view::npos) {
            to += means[at];
        } else if (c == '"' || c == '\\' || c == '/') {
            to += c;
        } else {
            throw Fault{};
        }
    }

    std::uint32_t four_digits() {
        std::uint32_t out = 0;
        if (rest_.size() < 4) throw Fault{};
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + 4, out, 16);
        if (error != std::errc() || end != rest_.data() + 4) throw Fault{};
        rest_.remove_prefix(4);
        return out;
    }

    void blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }
    char next() {
        if (rest_.empty()) throw Fault{};
        const char c = rest_[0];
        rest_.remove_prefix(1);
        return c;
    }
    void take(char c) {
        blanks();
        if (next() != c) throw Fault{};
    }
    // Takes the character if it is the next one.
    bool takes(char c) {
        blanks();
        if (rest_.empty() || rest_[0] != c) return false;
        rest_.remove_prefix(1);
        return true;
    }

    std::string_view rest_;
    int depth_ = 0;
    std::string path_;                                         // of the value that is read
    std::optional<std::map<std::string, std::string>> leaves_; // none: they are not wanted
};

} // namespace

std::map<std::string, std::string> json_values(const std::string& text) {
    try {
        return Parser(text).object();
    } catch (const Fault&) {
        return {};
    }
}

std::map<std::string, std::string> json_leaves(const std::string& text) {
    try {
        return Parser(text).leaves();
    } catch (const Fault&) {
        return {};
    }
}

} // namespace filum::wire
