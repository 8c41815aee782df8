#include "cli/document.hpp"

#include "base/number.hpp"
#include "cli/headings.hpp"
#include "cli/lines.hpp"
#include "cli/needs.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace filum::cli {

namespace {

std::string join(const std::vector<std::string>& all, const char* between) {
    std::string out;
    for (const auto& one : all) out += (out.empty() ? "" : between) + one;
    return out;
}

std::string value_name(const Option& o) {
    if (std::holds_alternative<bool*>(o.target)) return "";
    if (!o.choices.empty()) return join(o.choices, "|");
    return o.unit.empty() ? "TEXT" : o.unit;
}

std::string left_part(const Option& o) {
    const std::string value = value_name(o);
    return "--" + o.name + (value.empty() ? "" : " " + value);
}

// The help of an option, followed by its conditions.
std::string help_text(const Option& o) { return o.help + (o.needs.empty() ? "" : " (" + needs_text(o.needs) + ")"); }

std::string help_and_default(const Option& o) {
    const std::string value = value_text(o);
    const bool flag = std::holds_alternative<bool*>(o.target);
    return help_text(o) + (flag || value.empty() ? "" : " [" + value + "]");
}

// The options that every command has.
std::vector<Option> common() {
    static std::string output = "-";
    static std::int64_t threads = 0;
    static std::string notes = "look";
    static bool off = false;
    return {{"output", &output, "FILE", "where to write; a named file appears only when it is complete"},
            {"threads", &threads, "N", "how many threads to use, 0 for all cores; never changes the result"},
            {"quiet", &off, "", "no warnings on standard error"},
            Option{"notes", &notes, "",
                   "which notes to print: all, with harmless ones; those to look at; those that will fail"}
                .one_of({"all", "look", "will-fail"}),
            {"help", &off, "", "this text"},
            {"version", &off, "", "the version"}};
}

std::vector<Option> with_common(const Spec& spec) {
    std::vector<Option> all = spec.options;
    for (Option& o : common()) all.push_back(std::move(o));
    return all;
}

std::string usage(const Spec& spec) {
    return spec.name + " [OPTIONS]" + (spec.arguments.empty() ? "" : " " + spec.arguments);
}

constexpr std::size_t kWidest = 100; // characters of a line of a help

std::string wrap(const std::string& text, std::size_t indent) { return wrapped(text, indent, kWidest); }

constexpr const char* kExits[][2] = {{"0", "all went well"},
                                     {"1", "the work could not be done"},
                                     {"2", "the command line is wrong"},
                                     {"3", "the input is not what it should be"},
                                     {"4", "the input ends too early: a stage before did not finish"},
                                     {"5", "reading or writing failed"}};

// `text` escaped for a manual page: no part of it is read as a roff request or ends an argument.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
        if (c == '"')
            out += "\\(dq";
        else if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else
            out += c;
    }
    return out;
}

// The name of a manual page. Pages are installed as filum-slice.1 and so on, so that they do not hide pages of other
// programs.
std::string page_name(const Spec& spec) { return spec.name == "filum" ? spec.name : "filum-" + spec.name; }

// The row of an option in a table in Markdown.
std::string table_row(const Option& o) {
    std::string left = left_part(o);
    for (std::size_t at = 0; (at = left.find('|', at)) != std::string::npos; at += 2) left.insert(at, "\\");
    const bool flag = std::holds_alternative<bool*>(o.target);
    return "| `" + left + "` | " + help_text(o) + " | " + (flag ? "" : value_text(o)) + " |\n";
}

// `text` with its first letter as a capital.
std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

} // namespace

std::string version() { return FILUM_VERSION; }

std::string commit() {
    std::error_code failed;
    const auto self = std::filesystem::read_symlink("/proc/self/exe", failed);
    for (const char* share : {"share", "../share"}) {
        std::ifstream file(self.parent_path().parent_path() / share / "filum" / "commit");
        if (std::string name; file >> name) return " (commit " + name + ")";
    }
    return "";
}

std::string value_text(const Option& o) {
    if (auto* const* d = std::get_if<double*>(&o.target)) return shortest_text(**d);
    if (auto* const* i = std::get_if<std::int64_t*>(&o.target)) return std::to_string(**i);
    if (auto* const* b = std::get_if<bool*>(&o.target)) return **b ? "true" : "false";
    if (auto* const* s = std::get_if<std::string*>(&o.target)) return **s;
    if (const auto* e = std::get_if<EnumTarget>(&o.target)) return o.choices[e->choice(e->field)];
    std::string out;
    for (const double v : **std::get_if<std::vector<double>*>(&o.target))
        out += (out.empty() ? "" : ",") + shortest_text(v);
    return out;
}

Port reads(stream::Payload p) {
    return {Port::Kind::stream, p, p == stream::Payload::unknown ? "any stream" : std::string(stream::name(p))};
}
Port writes(stream::Payload p) { return reads(p); }
Port file(std::string text) { return {Port::Kind::file, stream::Payload::unknown, std::move(text)}; }
Port text(std::string text) { return {Port::Kind::text, stream::Payload::unknown, std::move(text)}; }
Port nothing() { return {}; }

std::string help(const Spec& spec) {
    std::string out = spec.name + " - " + spec.synopsis + "\n\nusage: " + usage(spec) + "\n";
    if (spec.in.kind != Port::Kind::none) out += "reads:  " + spec.in.text + "\n";
    if (spec.out.kind != Port::Kind::none) out += "writes: " + spec.out.text + "\n";
    out += "memory: " + spec.memory + "\n\n" + wrap(spec.description, 0) + "\n";
    for (const Section& section : sections(spec, common())) {
        out += "\n" + wrap(heading_text(section), 0) + ":\n";
        for (const Option& o : section.options) {
            std::string left = "  " + left_part(o);
            if (left.size() < 30)
                left.resize(30, ' ');
            else
                left += "\n" + std::string(30, ' ');
            out += left + wrap(help_and_default(o), 30) + "\n";
        }
    }
    if (!spec.examples.empty()) out += "\nexamples:\n";
    for (const Example& e : spec.examples) out += "  " + e.command + "\n      " + e.says + "\n";
    out += "\nexit codes:\n";
    for (const auto& e : kExits) out += std::string("  ") + e[0] + "  " + e[1] + "\n";
    return out;
}

std::string man_page(const Spec& spec) {
    std::string out = ".TH " + page_name(spec) + " 1 \"\" \"filum " + version() + "\" \"Filum\"\n";
    out += ".SH NAME\n" + roff(page_name(spec) + " - " + spec.synopsis) + "\n";
    out += ".SH SYNOPSIS\n" + roff(usage(spec)) + "\n.SH DESCRIPTION\n";
    std::string body = roff(spec.description);
    for (std::size_t at = 0; (at = body.find("\n\n", at)) != std::string::npos; at += 4) body.replace(at, 2, "\n.PP\n");
    out += body + "\n.SH OPTIONS\n";
    for (const Section& section : sections(spec, common())) {
        if (!section.heading.empty()) out += ".SS " + roff(heading_text(section)) + "\n";
        for (const Option& o : section.options)
            out += ".TP\n.B " + roff(left_part(o)) + "\n" + roff(help_and_default(o)) + "\n";
    }
    if (spec.in.kind != Port::Kind::none) out += ".SH INPUT\n" + roff(spec.in.text) + "\n";
    if (spec.out.kind != Port::Kind::none) out += ".SH OUTPUT\n" + roff(spec.out.text) + "\n";
    out += ".SH MEMORY USAGE\n" + roff(spec.memory) + "\n.SH EXAMPLES\n";
    for (const Example& e : spec.examples) out += ".TP\n.B " + roff(e.command) + "\n" + roff(e.says) + "\n";
    out += ".SH DIAGNOSTICS\n";
    for (const auto& e : kExits) out += std::string(".TP\n.B ") + e[0] + "\n" + e[1] + "\n";
    if (!spec.see_also.empty()) out += ".SH SEE ALSO\n" + join(spec.see_also, "(1), ") + "(1)\n";
    return out;
}

std::string markdown(const Spec& spec) {
    std::string out = "# " + spec.name + "\n\n" + spec.synopsis + "\n\n    " + usage(spec) + "\n\n";
    out += "| reads | writes | memory |\n|---|---|---|\n| " + (spec.in.text.empty() ? "-" : spec.in.text) + " | " +
           (spec.out.text.empty() ? "-" : spec.out.text) + " | " + spec.memory + " |\n\n" + spec.description + "\n\n";
    out += "## Options\n\n";
    for (const Section& section : sections(spec, common())) {
        if (!section.heading.empty()) out += "### " + capitalised(heading_text(section)) + "\n\n";
        out += "| option | what it does | default |\n|---|---|---|\n";
        for (const Option& o : section.options) out += table_row(o);
        out += "\n";
    }
    out += "## Examples\n\n";
    for (const Example& e : spec.examples) out += e.says + "\n\n    " + e.command + "\n\n";
    out += "## Exit codes\n\n| code | meaning |\n|---|---|\n";
    for (const auto& e : kExits) out += std::string("| ") + e[0] + " | " + e[1] + " |\n";
    return out;
}

std::string completion_line(const Spec& spec) {
    std::string out = spec.name;
    for (const Option& o : with_common(spec)) {
        out += " --" + o.name;
        if (!o.choices.empty())
            out += "={" + join(o.choices, ",") + "}";
        else if (const std::string value = value_name(o); !value.empty())
            out += "=" + value;
    }
    return out + "\n";
}

namespace {

bool is_number(const Option& o) {
    return std::holds_alternative<double*>(o.target) || std::holds_alternative<std::int64_t*>(o.target) ||
           std::holds_alternative<std::vector<double>*>(o.target);
}

// The allowed values: "LEAST MOST", followed by " open" if LEAST itself is not allowed and " zero" if 0 is allowed too.
std::string range(const Option& o) {
    return shortest_text(o.min) + " " + shortest_text(o.max) + (o.open_min ? " open" : "") + (o.zero ? " zero" : "");
}

} // namespace

std::string contract(const Spec& spec) {
    const auto kind = [](const Port& p) -> std::string {
        switch (p.kind) {
        case Port::Kind::none:
            return "none";
        case Port::Kind::file:
            return "file";
        case Port::Kind::text:
            return "text";
        case Port::Kind::stream:
            return "stream " + std::string(stream::name(p.payload));
        }
        return "";
    };
    std::string out = "synopsis " + spec.synopsis + "\nin " + kind(spec.in) + "\nout " + kind(spec.out) + "\n";
    for (const Option& o : with_common(spec)) {
        const std::string value = value_name(o);
        out += (value.empty() ? "flag " + o.name : "option " + o.name + " " + value) + "\n";
        out += "default " + o.name + " " + value_text(o) + "\n";
        if (is_number(o)) out += "range " + o.name + " " + range(o) + "\n";
        if (o.limit) out += "limit " + o.name + "\n";
        if (!o.needs.empty()) out += "needs " + o.name + " " + o.needs + "\n";
    }
    for (const Example& e : spec.examples) out += "example " + e.command + "\n";
    return out;
}

} // namespace filum::cli
