#include "cli/parse.hpp"

#include "cli/output_name.hpp"

#include "base/nearest.hpp"
#include "base/number.hpp"
#include "cli/document.hpp"
#include "cli/needs.hpp"
#include "cli/other_names.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace filum::cli {

namespace {

[[noreturn]] void misused(const std::string& why) { throw Error(Exit::usage, why); }

void check_range(const Option& o, double v) {
    if (o.zero && v == 0) return;
    if (v < o.min || v > o.max || (o.open_min && v == o.min) || !std::isfinite(v)) {
        std::string limits;
        if (std::isfinite(o.min)) limits += (o.open_min ? " above " : " at least ") + shortest_text(o.min);
        if (std::isfinite(o.max)) limits += (limits.empty() ? " at most " : " and at most ") + shortest_text(o.max);
        misused("cannot use '" + shortest_text(v) + "' for --" + o.name + ": it must be" + (o.zero ? " 0, or" : "") +
                (limits.empty() ? " a finite number" : limits));
    }
}

double number(const Option& o, const std::string& text) {
    const double v = parse_number(text, "--" + o.name);
    check_range(o, v);
    return v;
}

std::vector<double> number_list(const Option& o, const std::string& text) {
    std::vector<double> out;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        out.push_back(number(o, text.substr(at, comma - at)));
        at = comma + 1;
    }
    const bool fits = out.size() == o.count || (o.repeats && out.size() % o.count == 0);
    if (o.count != 0 && !fits)
        misused("cannot use '" + text + "' for --" + o.name + ": it takes " + std::to_string(o.count) +
                " numbers with commas between");
    return out;
}

// The index of `text` among the choices of the option; 0 if it has no choices. Throws Error(usage) for another text.
std::size_t choice(const Option& o, const std::string& text) {
    const auto found = std::find(o.choices.begin(), o.choices.end(), text);
    if (o.choices.empty() || found != o.choices.end()) return static_cast<std::size_t>(found - o.choices.begin());
    std::string all;
    for (const auto& c : o.choices) all += (all.empty() ? "" : ", ") + c;
    misused("cannot use '" + text + "' for --" + o.name + ": it must be one of " + all + did_you_mean(text, o.choices));
}

void store(const Option& o, const std::string& text) {
    if (auto* const* d = std::get_if<double*>(&o.target))
        **d = number(o, text);
    else if (auto* const* l = std::get_if<std::vector<double>*>(&o.target))
        **l = number_list(o, text);
    else if (const auto* e = std::get_if<EnumTarget>(&o.target))
        e->set(e->field, choice(o, text));
    else if (auto* const* s = std::get_if<std::string*>(&o.target)) {
        choice(o, text);
        **s = text;
    } else if (auto* const* i = std::get_if<std::int64_t*>(&o.target)) {
        const double v = number(o, text);
        if (v != std::floor(v) || std::abs(v) > 9e15)
            misused("cannot use '" + text + "' for --" + o.name + ": it must be a whole number");
        **i = static_cast<std::int64_t>(v);
    }
}

void bind(CLI::App& app, const Option& o) {
    if (auto* const* flag = std::get_if<bool*>(&o.target)) {
        app.add_flag("--" + o.name, **flag, o.help);
        return;
    }
    if (o.repeats) {
        const bool numbers = std::holds_alternative<std::vector<double>*>(o.target);
        const auto all = [o, numbers](const std::vector<std::string>& texts) {
            std::string list;
            for (const std::string& text : texts) {
                if (numbers) number_list(o, text); // refuses a use with too few numbers
                list += (list.empty() ? "" : numbers ? "," : ";") + text;
            }
            store(o, list);
        };
        app.add_option_function<std::vector<std::string>>("--" + o.name, all, o.help)
            ->allow_extra_args(false)
            ->take_all();
        return;
    }
    app.add_option_function<std::string>(
           "--" + o.name, [o](const std::string& text) { store(o, text); }, o.help)
        ->take_last();
}

// The document that the argument `verb` asks for, or "". --print-... is for the build and the tests, and counts only as
// the first argument.
std::string document(const std::string& verb, const Spec& spec) {
    if (verb == "--print-man") return man_page(spec);
    if (verb == "--print-markdown") return markdown(spec);
    if (verb == "--print-completion") return completion_line(spec);
    if (verb == "--print-contract") return contract(spec);
    for (const Spec::Page& page : spec.pages)
        if (verb == "--print-" + page.name) return page.text();
    if (verb == "--version") return spec.name + " (filum) " + version() + commit() + "\n";
    if (verb == "--help" || verb == "-h") return help(spec);
    return "";
}

// The message of the CLI library in the grammar of Filum: one line, lower case, no full stop.
std::string in_house(std::string what) {
    what = what.substr(0, what.find('\n'));
    if (what.size() > 1 && std::islower(static_cast<unsigned char>(what[1])) != 0)
        what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
    while (what.ends_with('.')) what.pop_back();
    return what;
}

// Takes the first argument as value of the leading option if it is one of its choices.
void take_leading(const Spec& spec, Io& io) {
    for (const Option& o : spec.options) {
        if (spec.leading.empty() || o.name != spec.leading || io.inputs.empty()) continue;
        if (std::find(o.choices.begin(), o.choices.end(), io.inputs.front()) == o.choices.end()) continue;
        store(o, io.inputs.front());
        io.inputs.erase(io.inputs.begin());
    }
}

// Throws Error(usage) for an option that does not exist, with a suggestion if a similar one exists.
[[noreturn]] void unknown(const std::string& word, const Spec& spec) {
    const std::string name = word.substr(0, word.find('='));
    const std::size_t dashes = std::min(name.find_first_not_of('-'), name.size());
    std::vector<std::string> names{"output", "threads", "quiet", "notes", "help", "version"};
    for (const Option& o : spec.options) names.push_back(o.name);
    std::string meant = as_command(spec.name, name.substr(dashes));
    if (meant.empty()) meant = in_our_words(name.substr(dashes), names);
    if (meant.empty()) meant = did_you_mean(name.substr(dashes), names, "--");
    misused("unknown option '" + word + "'" + (meant.empty() ? "; see '" + spec.name + " --help'" : meant));
}

// Records the options that differ from their defaults. Throws Error(usage) if one of them has no effect together with
// the other options.
void check_needs(const Spec& spec, const std::vector<std::string>& defaults, Io& io) {
    const Lookup lookup = [&](const std::string& name) -> OptionState {
        for (std::size_t i = 0; i < spec.options.size(); ++i)
            if (spec.options[i].name == name)
                return {value_text(spec.options[i]), value_text(spec.options[i]) != defaults[i]};
        throw std::logic_error("--" + name + " is no option of " + spec.name);
    };
    for (const Option& o : spec.options) {
        if (!lookup(o.name).changed) continue;
        io.given.push_back(o.name);
        if (const auto why = fault(o.name, o.needs, lookup)) misused(*why);
    }
}

// The lowest grade of notes that --notes shows.
Grade least_grade(const std::string& text) {
    for (const auto& [word, grade] :
         {std::pair{"all", Grade::harmless}, {"look", Grade::look}, {"will-fail", Grade::will_fail}})
        if (text == word) return grade;
    misused("cannot use '" + text + "' for --notes: it must be all, look or will-fail");
}

void read_command_line(int argc, char** argv, const Spec& spec, Io& io) {
    CLI::App app;
    app.set_help_flag();
    for (const Option& o : spec.options) bind(app, o);
    app.add_option("--output,-o", io.output);
    app.add_option("--threads", io.threads)->check(CLI::Range(0, 1024));
    app.add_flag("--quiet,-q", io.quiet);
    app.add_option_function<std::string>("--notes", [&](const std::string& text) { io.notes = least_grade(text); });
    app.add_option("input", io.inputs);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
        const auto left = app.remaining();
        unknown(left.empty() ? "" : left.front(), spec);
    } catch (const CLI::ParseError& e) {
        misused("cannot read the command line: " + in_house(e.what()) + "; see '" + spec.name + " --help'");
    }
    take_leading(spec, io);
    const std::size_t most = spec.many_inputs ? io.inputs.size() : spec.in.kind == Port::Kind::none ? 0 : 1;
    if (io.inputs.size() > most)
        misused("unexpected argument '" + io.inputs[most] + "'; see '" + spec.name + " --help'");
}

} // namespace

std::string parse(int argc, char** argv, const Spec& spec, Io& io) {
    io.program = spec.name;
    for (int i = 1; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--") break;
        if (i > 1 && std::string_view(argv[i]).starts_with("--print-")) continue;
        if (auto text = document(argv[i], spec); !text.empty()) return text;
    }
    std::vector<std::string> defaults;
    for (const Option& o : spec.options) defaults.push_back(value_text(o));
    read_command_line(argc, argv, spec, io);
    for (const auto& path : io.inputs)
        if (path.empty()) misused("cannot use '' as a file name; is a variable empty?");
    if (io.output.empty()) misused("cannot use '' for --output; is a variable empty?");
    if (spec.out.kind != Port::Kind::none && spec.name != "filum") // its commands write the output
        check_output_name(io.output, spec.name,
                          (spec.out.kind == Port::Kind::stream ? "a stream of " : "") + spec.out.text);
    if (!io.inputs.empty()) io.input = io.inputs.front();
    check_needs(spec, defaults, io);
    for (std::size_t i = 0; i < defaults.size(); ++i) {
        const Option& o = spec.options[i];
        if (!o.same.empty()) io.same.push_back({o.name, o.same});
        if (!o.setting) continue;
        const std::string value = value_text(o);
        io.settings.push_back({o.name, value, value != defaults[i]});
    }
    return "";
}

} // namespace filum::cli
