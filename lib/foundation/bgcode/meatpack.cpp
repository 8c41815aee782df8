#include "bgcode/meatpack.hpp"

#include <algorithm>
#include <cstdint>

namespace filum::bgcode {

namespace {

constexpr unsigned char kSignal = 0xFF;
enum Command : unsigned char {
    no_blanks_off = 246,
    no_blanks_on = 247,
    reset = 249,
    packing_off = 250,
    packing_on = 251
};
constexpr unsigned kFull = 0xF; // the character follows as a byte of its own
constexpr std::string_view kCommon = "0123456789. \nGX";
constexpr std::size_t kBlank = 11; // 'E' where blanks are left out

class Unpacker {
  public:
    std::string take() { return std::move(out_); }

    void byte(unsigned char c) {
        if (c == kSignal && signals_ < 2) return void(++signals_);
        if (signals_ == 2) {
            signals_ = 0;
            return command(c);
        }
        if (signals_ == 1) character(kSignal);
        signals_ = 0;
        character(c);
    }

  private:
    void command(unsigned char c) {
        if (c == packing_on || c == packing_off || c == reset) packing_ = c == packing_on;
        if (c == no_blanks_on || c == no_blanks_off) no_blanks_ = c == no_blanks_on;
    }

    [[nodiscard]] char common(unsigned k) const { return k == kBlank && no_blanks_ ? 'E' : kCommon[k]; }

    // Appends a character, but no empty line: the packer adds some after G codes.
    void put(char c) {
        if (c != '\n' || (!out_.empty() && out_.back() != '\n')) out_ += c;
    }

    void character(unsigned char c) {
        if (!packing_) {
            put(static_cast<char>(c));
            return;
        }
        if (full_ > 0) {
            put(static_cast<char>(c));
            --full_;
            if (behind_ != 0) put(behind_);
            behind_ = 0;
            return;
        }
        const unsigned low = c & 0xFU, high = c >> 4U;
        if (low == kFull) {
            full_ = high == kFull ? 2 : 1;
            if (high != kFull) behind_ = common(high);
            return;
        }
        put(common(low));
        if (common(low) == '\n') return; // the high half only fills up a line with an odd number of characters
        if (high == kFull)
            full_ = 1;
        else
            put(common(high));
    }

    std::string out_;
    int signals_ = 0, full_ = 0;
    char behind_ = 0; // a packed character that follows a full one
    bool packing_ = false, no_blanks_ = false;
};

void command(Command c, std::string& out) {
    out += static_cast<char>(kSignal);
    out += static_cast<char>(kSignal);
    out += static_cast<char>(c);
}

unsigned code_of(char c) {
    if (c == 'E') return kBlank;
    const auto at = c == ' ' ? kCommon.npos : kCommon.find(c);
    return at == kCommon.npos ? kFull : static_cast<unsigned>(at);
}

void pack_line(const std::string& line, std::string& out) {
    for (std::size_t i = 0; i < line.size(); i += 2) {
        const char a = line[i], b = i + 1 < line.size() ? line[i + 1] : '\n';
        const unsigned low = code_of(a), high = code_of(b);
        out += static_cast<char>(low | (high << 4U));
        if (low == kFull) out += a;
        if (high == kFull) out += b;
    }
}

// The line without its comment and without blanks at its ends; G codes without any blanks.
std::string plain_line(std::string_view line) {
    std::string out(line.substr(0, line.find(';')));
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!out.empty() && is_blank(out.back())) out.pop_back();
    out.erase(out.begin(), std::find_if_not(out.begin(), out.end(), is_blank));
    if (out.size() > 1 && out[0] == 'G' && out[1] >= '0' && out[1] <= '9') std::erase(out, ' ');
    return out;
}

} // namespace

std::string unpacked(std::string_view data) {
    Unpacker unpacker;
    for (const char c : data) unpacker.byte(static_cast<unsigned char>(c));
    return unpacker.take();
}

std::string packed(std::string_view text) {
    std::string out;
    command(packing_on, out);
    command(no_blanks_on, out);
    bool packing = true;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const bool comment = line.starts_with(';');
        const std::string code = comment ? "" : plain_line(line);
        if (!comment && code.empty()) continue;
        if (packing == comment) command(comment ? packing_off : packing_on, out);
        packing = !comment;
        if (comment)
            out.append(line).push_back('\n');
        else
            pack_line(code + '\n', out);
    }
    return out;
}

} // namespace filum::bgcode
