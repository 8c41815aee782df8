#include "machine/template.hpp"

#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>

namespace filum::machine {

namespace {

// One piece of a template: plain text, or the name between two braces.
struct Piece {
    enum class Kind { text, name, fault } kind;
    std::string_view text;
};

// Cuts the next piece off `rest`, which is not empty.
Piece next_piece(std::string_view& rest) {
    const auto take = [&rest](std::size_t n) {
        const auto head = rest.substr(0, n);
        rest.remove_prefix(n);
        return head;
    };
    const std::size_t brace = rest.find_first_of("{}");
    if (brace != 0) return {Piece::Kind::text, take(std::min(brace, rest.size()))};
    if (rest.size() > 1 && rest[1] == rest[0]) {
        const auto pair = take(2);
        return {Piece::Kind::text, pair.substr(0, 1)};
    }
    const std::size_t close = rest.find_first_of("{}\n", 1);
    if (rest[0] == '}' || close == std::string_view::npos || rest[close] != '}')
        return {Piece::Kind::fault, take(rest.size())};
    const auto whole = take(close + 1);
    return {Piece::Kind::name, whole.substr(1, whole.size() - 2)};
}

} // namespace

const std::vector<std::string>& known_placeholders() {
    static const std::vector<std::string> names = {"x_min",
                                                   "x_max",
                                                   "y_min",
                                                   "y_max",
                                                   "z_min",
                                                   "z_max",
                                                   "x_start",
                                                   "y_start",
                                                   "z_start",
                                                   "bed_x_min",
                                                   "bed_x_max",
                                                   "bed_y_min",
                                                   "bed_y_max",
                                                   "bed_z_max",
                                                   "z_park",
                                                   "percent",
                                                   "minutes_left",
                                                   "acceleration",
                                                   "fan_speed",
                                                   "layer",
                                                   "layers",
                                                   "z",
                                                   "height",
                                                   "path_len",
                                                   "travel_len",
                                                   "time",
                                                   "strokes",
                                                   "material_mm3",
                                                   "material_e",
                                                   "travel_feed",
                                                   "z_feed",
                                                   "tool_no",
                                                   "cut_dwell",
                                                   "cut_dwell_ms",
                                                   "tension_dwell",
                                                   "tension_dwell_ms",
                                                   "purge_x",
                                                   "purge_y",
                                                   "purge_x_end",
                                                   "purge_y_end",
                                                   "tilt_axis_speed",
                                                   "turn_axis_speed",
                                                   "tilt_axis_acceleration",
                                                   "turn_axis_acceleration",
                                                   "tilt_axis_jump",
                                                   "turn_axis_jump"};
    return names;
}

TemplateFault check_template(std::string_view text, const Values& own) {
    const auto& known = known_placeholders();
    std::string_view rest = text;
    while (!rest.empty()) {
        const auto at = text.size() - rest.size();
        const Piece p = next_piece(rest);
        if (p.kind == Piece::Kind::text) continue;
        const auto line =
            static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
        if (p.kind == Piece::Kind::fault) return {"a brace has no partner; write {{ or }} for a plain one", line};
        const std::string name(p.text);
        if (own.count(name) == 0 && std::find(known.begin(), known.end(), name) == known.end())
            return {std::string("unknown placeholder '{")
                        .append(name)
                        .append("}'; add '")
                        .append(name)
                        .append("' to [values] or see postproc --help"),
                    line};
    }
    return {};
}

std::string expand(std::string_view text, const Values& values, int decimals) {
    std::string out;
    while (!text.empty()) {
        const Piece p = next_piece(text);
        if (p.kind == Piece::Kind::text) {
            out += p.text;
            continue;
        }
        const auto it = values.find(std::string(p.text));
        if (p.kind == Piece::Kind::fault || it == values.end())
            throw Error(Exit::bad_input, "cannot fill in a template: nothing known for '" + std::string(p.text) + "'");
        append_fixed(out, it->second, decimals);
    }
    return out;
}

} // namespace filum::machine
