#include "ingest/line.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace filum::ingest {

bool Line::places() const {
    return std::any_of(has.begin(), has.end(), [](bool b) { return b; });
}

bool Line::names() const {
    return extruder_named || std::any_of(named.begin(), named.end(), [](bool b) { return b; });
}

namespace {

bool is_other_axis(char letter) { return std::string_view("ABCUVW").find(letter) != std::string_view::npos; }

// Adds a word that is not the extruder's and not that of an axis of the machine.
void add_word(const machine::Word& word, double unit, Line& to) {
    const double v = word.value;
    switch (word.letter) {
    case 'G':
        return to.g.push_back(v);
    case 'M':
        return to.m.push_back(v);
    case 'T':
        return void(to.tool = v);
    case 'I':
        return void(to.arc.i = v * unit);
    case 'J':
        return void(to.arc.j = v * unit);
    case 'R':
        return void(to.arc.r = v * unit);
    case 'P':
        to.arc.turns = static_cast<int>(v);
        return void(to.p = v);
    case 'L':
        return void(to.l = v);
    case 'S':
        return void(to.s = v);
    case 'D':
        return void(to.d = v);
    default:
        break;
    }
    if (is_other_axis(word.letter)) to.foreign_axis = word.letter;
}

} // namespace

Line sorted(const machine::Words& words, const machine::Profile& profile, char extruder, bool counts, double unit) {
    Line out;
    for (const machine::Word& word : words.words) {
        if (out.first == 0 && word.letter != 'N') out.first = word.letter;
        const std::size_t k = machine::axis_of(profile, word.letter);
        if (k < out.numbers.size()) {
            out.named[k] = true;
            if (word.flag) continue;
            out.numbers[k] = word.value * (k < 3 ? unit : 1);
            out.has[k] = true;
            continue;
        }
        if (counts && word.letter == extruder) out.extruder_named = true;
        if (word.flag) {
            if (is_other_axis(word.letter)) out.foreign_axis = word.letter;
        } else if (counts && word.letter == extruder) {
            out.extruder = word.value * unit;
            out.extruder_decimals = word.decimals;
        } else
            add_word(word, unit, out);
    }
    return out;
}

} // namespace filum::ingest
