#include "stressfield/vtu_cases.hpp"

#include "stressfield/formats.hpp"
#include "stressfield/units.hpp"

#include <algorithm>
#include <map>

namespace filum::stressfield {

namespace {

// The name without its unit, in the characters that names of cases may have.
std::string case_name(std::string name) {
    const std::size_t bracket = name.find_first_of("[({");
    if (bracket != name.npos && bracket > 0) name.resize(bracket);
    while (!name.empty() && name.back() == ' ') name.pop_back();
    for (char& c : name)
        if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')) c = '-';
    return name.empty() ? "stress" : name;
}

std::string quoted(const std::vector<std::string>& names) {
    std::string out;
    for (const auto& n : names) out += (out.empty() ? "'" : ", '") + n + "'";
    return out;
}

// The quantity that the prefixes of component names state: "SXX" or "EPXX".
Quantity quantity_of_components(const ArrayHead& head) {
    Quantity out = Quantity::unknown;
    for (const auto& name : head.components) {
        const auto c = component_of(name);
        const Quantity q = c ? quantity_of(c->prefix) : Quantity::unknown;
        if (q == Quantity::strain) return q;
        if (q == Quantity::stress) out = q;
    }
    return out;
}

class CaseSelector {
  public:
    CaseSelector(const ReadOptions& options, const std::string& writer, const std::string& file, Notes& notes)
        : options_(options), writer_(writer), file_(file), notes_(notes) {}

    std::vector<CaseSource> all(const std::vector<ArrayHead>& heads) {
        std::vector<std::string> strains, others;
        for (const auto& h : heads) {
            const auto named = order_of_names(h.components);
            if (h.width != 6 && h.width != 9 && !(named && h.width > 6)) continue;
            const Quantity q = quantity(h);
            if (q == Quantity::stress)
                out_.push_back(tensor(h));
            else
                (q == Quantity::strain ? strains : others).push_back(h.name);
        }
        add_groups(heads);
        if (out_.empty() && !others.empty())
            bad(file_, "no name says which of its arrays holds stresses: " + quoted(others) +
                           "; name those that do by --columns");
        if (!strains.empty()) left_out(NoteCode::strains_ignored, quoted(strains), strains.size());
        if (!others.empty()) left_out(NoteCode::array_ignored, quoted(others), others.size());
        note_assumed();
        return std::move(out_);
    }

    std::vector<CaseSource> asked(const std::vector<ArrayHead>& heads, const std::vector<std::string>& wanted) {
        for (const auto& h : heads) {
            if (std::find(wanted.begin(), wanted.end(), h.name) == wanted.end()) continue;
            if (h.width == 3)
                out_.push_back(vector(h));
            else if (h.width == 6 || h.width == 9 || order_of_names(h.components))
                out_.push_back(tensor(h));
            else
                bad(file_,
                    "its array '" + h.name + "' has " + std::to_string(h.width) + " numbers per point, not 3, 6 or 9");
        }
        note_assumed();
        return out_.size() < wanted.size() ? std::vector<CaseSource>() : std::move(out_);
    }

  private:
    // From the names of the array and of its components.
    Quantity quantity(const ArrayHead& h) const {
        const Quantity by_name = quantity_of(h.name), by_components = quantity_of_components(h);
        if (by_name != Quantity::unknown && by_components != Quantity::unknown && by_name != by_components)
            bad(file_, "its array '" + h.name + "' and its components '" + h.components.front() +
                           "' ... disagree on whether it holds stresses or strains; name it by --columns if it does");
        return by_name == Quantity::unknown ? by_components : by_name;
    }

    CaseSource source(const std::string& name, std::size_t width) {
        CaseSource out{case_name(name), {name}, width, {}, false, false, 1, ""};
        if (options_.stress_unit != "auto") {
            out.unit = options_.stress_unit;
            out.factor = *factor_of(Dimension::stress, out.unit);
            return out;
        }
        out.unit = unit_in(Dimension::stress, name);
        out.unit_named = !out.unit.empty();
        if (out.unit.empty()) out.unit = "MPa";
        const auto factor = factor_of(Dimension::stress, out.unit);
        if (!factor)
            bad(file_, "the unit '" + out.unit + "' of its array '" + name + "' is not known; give --stress-unit");
        out.factor = *factor;
        return out;
    }

    CaseSource tensor(const ArrayHead& h) {
        CaseSource out = source(h.name, h.width);
        if (!options_.order.empty()) {
            out.order = order_of_option(options_.order, h.width);
            out.both_halves = true;
            return out;
        }
        if (const auto named = order_of_names(h.components)) {
            out.order = *named;
            return out;
        }
        if (!h.components.empty())
            bad(file_, "the components of its array '" + h.name + "' are named " + quoted(h.components) +
                           ", which are not those of a tensor in x, y and z; give its order by --order");
        const std::string name = plain(h.name);
        for (const char* word : {"voigt", "mandel", "abaqus", "kelvin"})
            if (h.width == 6 && name.find(word) != name.npos)
                bad(file_, "the components of its array '" + h.name +
                               "' have no names, and its own name points to an order other than VTK's; give --order");
        if (h.width == 6 && !writer_.empty())
            bad(file_, "the components of its array '" + h.name + "' have no names, and " + writer_ +
                           " keeps the order of the program that wrote them; give --order, as vtk (xx yy zz xy yz "
                           "xz) or abaqus (xx yy zz xy xz yz)");
        out.order = vtk_order(h.width);
        out.assumed = h.width == 6;
        return out;
    }

    CaseSource vector(const ArrayHead& h) {
        static constexpr std::string_view kAxes = "xyz";
        for (std::size_t k = 0; k < h.components.size(); ++k) {
            const auto c = component_of(h.components[k]);
            const std::string last = plain(h.components[k]);
            const bool number =
                !last.empty() &&
                (last.back() == static_cast<char>('0' + k) || last.back() == static_cast<char>('1' + k)) &&
                quantity_of(last.substr(0, last.size() - 1)) != Quantity::stress; // S1, S2, S3 are principal stresses
            const bool axis = c && c->short_form && kAxes[static_cast<std::size_t>(c->row)] == kAxes[k];
            if (!axis && !number)
                bad(file_, "its array '" + h.name + "' is no vector in x, y and z: its components are named " +
                               quoted(h.components) + "; name an array of tensors or vectors by --columns");
        }
        return source(h.name, 3);
    }

    // Adds groups of arrays of one number that form a tensor of stresses: "stress_xx", "stress_xy" ...
    void add_groups(const std::vector<ArrayHead>& heads) {
        std::vector<std::string> prefixes; // in the order of the file
        std::map<std::string, std::vector<std::string>> groups;
        for (const auto& h : heads) {
            if (h.width != 1) continue;
            const auto c = component_of(without_unit(h.name));
            if (!c || c->prefix.empty() || quantity_of(c->prefix) != Quantity::stress) continue;
            if (groups[c->prefix].empty()) prefixes.push_back(c->prefix);
            groups[c->prefix].push_back(h.name);
        }
        for (const auto& prefix : prefixes) {
            std::vector<std::string> names;
            for (const auto& name : groups[prefix]) names.emplace_back(without_unit(name));
            const auto order = order_of_names(names);
            if (!order) continue;
            CaseSource next = source(groups[prefix].front(), 1);
            for (const auto& name : groups[prefix])
                if (source(name, 1).factor != next.factor)
                    bad(file_, "its arrays " + quoted(groups[prefix]) + " have several units; give --stress-unit");
            next.name = case_name(prefix);
            next.arrays = groups[prefix];
            next.order = *order;
            out_.push_back(next);
        }
    }

    void note_assumed() {
        std::vector<std::string> names;
        for (const auto& c : out_)
            if (c.assumed) names.push_back(c.arrays.front());
        if (!names.empty()) left_out(NoteCode::order_assumed, quoted(names), names.size());
    }

    void left_out(NoteCode code, const std::string& names, std::size_t count) {
        notes_.push_back(note(code, count, names));
    }

    const ReadOptions& options_;
    const std::string& writer_;
    const std::string& file_;
    Notes& notes_;
    std::vector<CaseSource> out_;
};

} // namespace

std::vector<CaseSource> cases_of(const std::vector<ArrayHead>& heads, const ReadOptions& options,
                                 const std::string& writer, const std::string& file, Notes& notes) {
    CaseSelector chooser(options, writer, file, notes);
    if (options.columns.empty()) return chooser.all(heads);
    std::vector<std::string> wanted;
    for (std::size_t from = 0; from <= options.columns.size();) {
        const std::size_t end = std::min(options.columns.find(',', from), options.columns.size());
        wanted.push_back(options.columns.substr(from, end - from));
        from = end + 1;
    }
    return chooser.asked(heads, wanted);
}

} // namespace filum::stressfield
