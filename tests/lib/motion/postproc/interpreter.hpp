// A small reader of G-code for the tests: written apart from the writer, and stricter than a firmware.
#pragma once

#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace interpreter {

struct State {
    double x = NAN, y = NAN, z = NAN, e = 0; // e: all that the extruder was turned, resets taken out
};

struct Move {
    State from, to;
    double de = 0, feed = 0;
    bool rapid = false;
    int stroke = 0; // how often M7 came before, 0 if M9 came since
    std::string line;
    [[nodiscard]] double xy() const { return std::hypot(to.x - from.x, to.y - from.y); }
};

struct Program {
    std::vector<Move> moves;        // G0 and G1, in order
    std::vector<std::string> other; // every other code line
    std::vector<std::string> comments;
    std::vector<std::string> all; // moves as "move", else the code, in order
};

// Takes comments off a line and keeps them.
inline std::string code_of(const std::string& line, std::vector<std::string>& comments) {
    std::string out;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == ';') {
            comments.push_back(line.substr(i + 1));
            break;
        }
        if (line[i] == '(') {
            const auto close = line.find(')', i);
            if (close == std::string::npos) throw std::runtime_error("comment not closed: " + line);
            comments.push_back(line.substr(i + 1, close - i - 1));
            i = close;
            continue;
        }
        out += line[i];
    }
    while (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
}

// A number of digits, a point, a sign; anything else (an exponent above all) is refused.
inline double plain_number(const std::string& text) {
    if (text.empty() || text.find_first_not_of("-.0123456789") != std::string::npos)
        throw std::runtime_error("no plain number: " + text);
    return std::strtod(text.c_str(), nullptr);
}

// Reads a program whose extruder word is `letter`.  Throws std::runtime_error for anything unexpected.
inline Program read(const std::string& text, char letter = 'E') {
    Program out;
    State at;
    bool relative_e = false;
    double base = 0, feed = 0; // e the controller shows = at.e - base
    int opened = 0;
    bool open = false;
    for (std::size_t begin = 0; begin < text.size();) {
        auto end = text.find('\n', begin);
        if (end == std::string::npos) throw std::runtime_error("last line has no end");
        const std::string line = code_of(text.substr(begin, end - begin), out.comments);
        begin = end + 1;
        if (line.empty()) continue;
        std::map<char, double> words;
        std::string command;
        const bool motion = line.starts_with("G0 ") || line.starts_with("G1 ") || line.starts_with("G92 ");
        for (std::size_t i = 0; motion && i < line.size();) {
            auto stop = line.find(' ', i);
            if (stop == std::string::npos) stop = line.size();
            const std::string word = line.substr(i, stop - i);
            if (i == 0)
                command = word;
            else if (!words.emplace(word[0], plain_number(word.substr(1))).second)
                throw std::runtime_error("word twice: " + line);
            i = stop + 1;
        }
        if (line == "M83") relative_e = true;
        if (line == "M82") relative_e = false;
        if (line == "M7") {
            ++opened;
            open = true;
        }
        if (line == "M9") open = false;
        if (!motion || command == "G92") {
            if (command == "G92" && words.count(letter) != 0) base = at.e - words[letter];
            out.other.push_back(line);
            out.all.push_back(line);
            continue;
        }
        Move m{at, at, 0, 0, command == "G0", open ? opened : 0, line};
        for (const auto& [name, value] : words) {
            if (name == 'X')
                m.to.x = value;
            else if (name == 'Y')
                m.to.y = value;
            else if (name == 'Z')
                m.to.z = value;
            else if (name == 'F')
                feed = value;
            else if (name == letter)
                m.to.e = relative_e && letter == 'E' ? at.e + value : value + base;
            else
                throw std::runtime_error("unknown word: " + line);
        }
        m.de = m.to.e - m.from.e;
        m.feed = feed;
        out.moves.push_back(m);
        out.all.emplace_back("move");
        at = m.to;
    }
    return out;
}

} // namespace interpreter
