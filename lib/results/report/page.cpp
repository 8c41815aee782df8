#include "report/page.hpp"

#include "base/json.hpp"
#include "base/number.hpp"
#include "report/assets.hpp"
#include "report/column.hpp"

#include <cmath>

namespace filum::report {

namespace {

// Writes a column as an element of its own, and its name and length to the list of the page.
void column(std::string& out, std::string& list, const std::string& name, const Column& numbers) {
    list += (list.back() == '{' ? "" : ",") + json_text(name) + ":" + std::to_string(numbers.size());
    out += "<script type=\"text/plain\" data-column=\"" + name + "\">" + packed(numbers) + "</script>\n";
}

std::string number(double v) { return std::isfinite(v) ? shortest_text(v) : "null"; }

std::string spots(const Content& c) {
    std::string out = "[";
    for (const Spot& s : c.spots)
        out += std::string(out.size() > 1 ? "," : "") + "[" + json_text(s.kind) + "," + json_text(s.what) + "," +
               number(s.x) + "," + number(s.y) + "," + number(s.z) + "," + std::to_string(s.layer) + "]";
    return out + "]";
}

std::string made(const Content& c) {
    std::string out = "[";
    for (const StageRecord& m : c.made) {
        out += std::string(out.size() > 1 ? "," : "") + "[" + json_text(m.program) + ",[";
        for (const auto& [name, value, changed] : m.settings)
            out += std::string(out.back() == '[' ? "" : ",") + "[" + json_text(name) + "," + json_text(value) + "," +
                   json_text(changed) + "]";
        out += "]]";
    }
    return out + "]";
}

std::string figures(const Content& c) {
    std::string out = "[";
    for (const auto& row : c.figures) {
        out += out.size() > 1 ? ",[" : "[";
        for (const std::string& cell : row) out += (out.back() == '[' ? "" : ",") + json_text(cell);
        out += "]";
    }
    return out + "]";
}

std::string fields(const Surface& s) {
    std::string out = "[";
    for (const Field& f : s.fields)
        out += std::string(out.size() > 1 ? "," : "") + "[" + json_text(f.name) + "," + number(f.low) + "," +
               number(f.high) + "]";
    return out + "]";
}

void columns(std::string& out, std::string& list, const Content& c) {
    const std::pair<const char*, const Column*> all[] = {{"x", &c.points.x},
                                                         {"y", &c.points.y},
                                                         {"z", &c.points.z},
                                                         {"width", &c.points.width},
                                                         {"height", &c.points.height},
                                                         {"speed", &c.points.speed},
                                                         {"nx", &c.points.nx},
                                                         {"ny", &c.points.ny},
                                                         {"nz", &c.points.nz},
                                                         {"start", &c.spans.start},
                                                         {"role", &c.spans.role},
                                                         {"feature", &c.spans.feature},
                                                         {"stroke", &c.spans.stroke},
                                                         {"layer", &c.spans.layer},
                                                         {"tool", &c.spans.tool},
                                                         {"taken", &c.spans.retraction},
                                                         {"ox", &c.outlines.x},
                                                         {"oy", &c.outlines.y},
                                                         {"ostart", &c.outlines.start},
                                                         {"olayer", &c.outlines.layer},
                                                         {"oz", &c.outlines.z},
                                                         {"ostroke", &c.outlines.stroke}};
    for (const auto& [name, numbers] : all) column(out, list, name, *numbers);
    for (std::size_t k = 0; k < c.surfaces.size(); ++k) {
        const Surface& s = c.surfaces[k];
        const std::string at = "s" + std::to_string(k);
        column(out, list, at + "x", s.x);
        column(out, list, at + "y", s.y);
        column(out, list, at + "z", s.z);
        column(out, list, at + "corner", s.corner);
        for (std::size_t f = 0; f < s.fields.size(); ++f)
            column(out, list, at + "f" + std::to_string(f), s.fields[f].value);
    }
}

// JSON for use inside a script element. Every '<' is replaced by its escape, so "</script" and "<!--" cannot
// occur. "<!--" followed by "<script" would hide the end of the element from a browser. In JSON '<' occurs only in
// strings, where the escape means the same.
std::string within_script(std::string_view json) {
    std::string out;
    out.reserve(json.size());
    for (const char c : json) {
        if (c == '<')
            out += "\\u003c";
        else
            out += c;
    }
    return out;
}

std::string data(const Content& c) {
    std::string elements, list = "{";
    columns(elements, list, c);
    std::string surfaces = "[";
    for (const Surface& s : c.surfaces) surfaces += (surfaces.size() > 1 ? "," : "") + fields(s);
    const std::string about = "{\"version\":1,\"name\":" + json_text(c.name) + ",\"payload\":" + json_text(c.payload) +
                              ",\"machine\":" + json_text(c.machine) + ",\"script\":" + json_text(c.script) +
                              ",\"spots\":" + spots(c) + ",\"made\":" + made(c) + ",\"figures\":" + figures(c) +
                              ",\"surfaces\":" + surfaces + "],\"columns\":" + list + "}}";
    return "<div class=\"program\" hidden>\n<script type=\"application/json\">" + within_script(about) + "</script>\n" +
           elements + "</div>\n";
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
    return out;
}

} // namespace

std::string page(std::span<const Content> contents) {
    std::string title;
    for (const Content& c : contents) title += (title.empty() ? "" : " | ") + c.name;
    std::string out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                      "<meta name=\"generator\" content=\"filum\">\n"
                      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
                      escaped(title) + " - Filum</title>\n<style>\n";
    out += asset("style.css");
    out += "</style>\n</head>\n<body>\n";
    out += asset("body.html");
    for (const Content& c : contents) out += data(c);
    for (const char* script :
         {"three.js", "data.js", "colours.js", "detail.js", "beads.js", "view.js", "layer.js", "panel.js", "main.js"}) {
        out += "<script>\n";
        out += asset(script);
        out += "\n</script>\n";
    }
    return out + "</body>\n</html>\n";
}

} // namespace filum::report
