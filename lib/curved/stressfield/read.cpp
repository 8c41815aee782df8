#include "stressfield/read.hpp"

#include "base/number.hpp"
#include "base/padding.hpp"
#include "stressfield/formats.hpp"
#include "stressfield/units.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <set>
#include <zlib.h>

namespace filum::stressfield {

namespace {

constexpr std::size_t kMaxFile = std::size_t{1} << 33; // unpacked size: a small file can contain terabytes
constexpr std::size_t kPiece = std::size_t{1} << 30;   // bytes per call

// Unpacks gzip; several members may follow each other.
std::string gunzip(std::string_view bytes, const std::string& name) {
    std::string out;
    z_stream z{};
    if (inflateInit2(&z, 15 + 16) != Z_OK) throw Error(Exit::failure, "cannot unpack " + name);
    const std::unique_ptr<z_stream, int (*)(z_stream*)> closer(&z, inflateEnd);
    std::size_t given = 0, made = 0;
    for (int state = Z_OK; state != Z_STREAM_END || given < bytes.size() || z.avail_in > 0;) {
        if (state == Z_STREAM_END) inflateReset(&z);
        if (z.avail_in == 0) {
            z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data() + given));
            z.avail_in = static_cast<uInt>(std::min(bytes.size() - given, kPiece));
            given += z.avail_in;
        }
        if (made == out.size()) out.resize(std::max(kPiece / 1024, 2 * out.size()));
        const std::size_t room = std::min(out.size() - made, kPiece);
        z.next_out = reinterpret_cast<Bytef*>(out.data() + made);
        z.avail_out = static_cast<uInt>(room);
        state = inflate(&z, Z_NO_FLUSH);
        made += room - z.avail_out;
        if (state == Z_BUF_ERROR) cut(name, "what gzip packed ends too early");
        if (state != Z_OK && state != Z_STREAM_END) bad(name, "what gzip packed is damaged");
        if (made > kMaxFile) bad(name, "it unpacks to more than 8 GiB");
    }
    out.resize(made);
    return out;
}

// Applies the units of options to a format without units.
void scale(Samples& samples, const ReadOptions& options) {
    const double length = options.unit == "auto" ? 1 : *factor_of(Dimension::length, options.unit);
    const double stress = options.stress_unit == "auto" ? 1 : *factor_of(Dimension::stress, options.stress_unit);
    for (Vec3& p : samples.points) p = length * p;
    for (Case& c : samples.cases) {
        for (Tensor& t : c.tensors)
            for (double& part : t) part *= stress;
        for (Principal& s : c.principals)
            for (double& part : s) part *= stress;
    }
}

bool proper(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
}

// MPa: ten times what the strongest fibres bear. Stresses of one tenth of a MPa in Pa are greater.
constexpr double kMostStress = 1e5;

// Refuses stresses without a unit that no material bears in MPa. They are probably in Pa.
void check_size(const Samples& samples, const std::string& name) {
    for (const Case& c : samples.cases) {
        if (c.unit_named) continue;
        std::vector<double> size; // the largest stress of each point
        const auto add = [&](const auto& stresses) {
            for (const auto& own : stresses) {
                double most = 0;
                for (const double s : own)
                    if (std::isfinite(s)) most = std::max(most, std::abs(s));
                size.push_back(most);
            }
        };
        add(c.tensors);
        add(c.principals);
        if (size.empty()) continue;
        const auto middle = size.begin() + static_cast<long>(size.size() / 2);
        std::nth_element(size.begin(), middle, size.end());
        if (*middle > kMostStress)
            bad(name, "half of the stresses of '" + c.name + "' are greater than " +
                          shortest_text(std::round(*middle)) +
                          " MPa, which no material bears; give their unit by --stress-unit");
    }
}

// The text with line feeds instead of lone carriage returns.
std::string with_line_feeds(std::string_view bytes) {
    std::string out(bytes);
    std::replace(out.begin(), out.end(), '\r', '\n');
    return out;
}

std::string list_of(const Samples& samples) {
    std::string out;
    for (const Case& c : samples.cases) out += (out.empty() ? "" : ", ") + c.name;
    return out;
}

void rename(Samples& samples, const std::string& names, const std::string& file) {
    if (!names.empty()) {
        std::vector<std::string> words;
        for (std::size_t from = 0; from <= names.size();) {
            const std::size_t end = std::min(names.find(',', from), names.size());
            words.push_back(names.substr(from, end - from));
            from = end + 1;
        }
        if (words.size() != samples.cases.size())
            throw Error(Exit::usage, "cannot use '" + names + "' for --case: " + file + " has " +
                                         std::to_string(samples.cases.size()) + " load cases: " + list_of(samples));
        for (std::size_t i = 0; i < words.size(); ++i) samples.cases[i].name = words[i];
    }
    std::set<std::string> seen;
    for (Case& c : samples.cases)
        if (!proper(c.name) || !seen.insert(c.name).second)
            throw Error(Exit::usage, "cannot name a load case '" + c.name +
                                         "': names are different and of letters, digits, - and _; give --case");
}

// What a file is that holds no stresses Filum can read, and what to do; "" if it is unknown.
std::string foreign(std::string_view bytes) {
    const std::string_view start = bytes.substr(std::min(bytes.find_first_not_of(" \r\n"), bytes.size()));
    const std::string_view head = bytes.substr(0, 4096);
    const auto holds = [&](std::string_view text) { return head.find(text) != head.npos; };
    if (start.starts_with("# vtk")) return "it is of VTK's old kind of file; save it as .vtu";
    if (start.starts_with("<") && holds("<Xdmf"))
        return "it is an XDMF file; save it as .vtu, for instance by ParaView";
    if (bytes.starts_with("\x89HDF")) return "it is an HDF5 file; save its results as .vtu or CSV";
    if (bytes.starts_with("PK\x03\x04")) return "it is a spreadsheet or another ZIP archive; save the table as CSV";
    if (start.starts_with("$MeshFormat")) return "it is a mesh of Gmsh; save the results as .vtu or CSV";
    if (start.starts_with("-1\n") || start.starts_with("-1\r"))
        return "it is a universal file (.unv); save its results as .vtu or CSV";
    if (start.starts_with("*") && start.size() > 1 &&
        (start[1] == '*' || std::isalpha(static_cast<unsigned char>(start[1])) != 0))
        return "it is the input of a finite element program, without results; give the .frd of CalculiX, or the "
               "stresses as CSV";
    if (holds("Abaqus") && !holds(","))
        return "it is a printed text of Abaqus; write the stresses at the nodes as CSV (a report of the probe or field "
               "output)";
    if (start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff"))
        return "it is text of 16 bits per letter; save it as UTF-8";
    // A VTU file may hold bytes of numbers.
    if (!start.starts_with("<") && bytes.substr(0, 1024).find('\0') != bytes.npos)
        return "it is a binary file of an unknown kind; save its results as .vtu or CSV";
    return "";
}

Samples read_any(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes) {
    bytes = without_padding(bytes);
    const std::string_view start = bytes.substr(std::min(bytes.find_first_not_of(" \r\n"), bytes.size()));
    const bool frd = start.starts_with("1C") || start.starts_with("1U"), vtu = start.starts_with("<");
    if (frd && !options.columns.empty())
        throw Error(Exit::usage, "cannot use --columns: " + name + " is an FRD file, whose columns are fixed");
    if (!frd && options.step != "all")
        throw Error(Exit::usage, "cannot use --step: " + name + " is no FRD file and has no steps");
    if (!vtu && !options.order.empty())
        throw Error(Exit::usage, "cannot use --order: " + name + " is no VTU file; " +
                                     (frd ? "the order of an FRD file is fixed" : "name columns by --columns"));
    if ((frd || vtu) && options.decimal != "auto")
        throw Error(Exit::usage, "cannot use --decimal: " + name + " is no CSV file");
    if (frd) {
        const bool returns = bytes.find('\n') == bytes.npos && bytes.find('\r') != bytes.npos;
        const std::string mended = returns ? with_line_feeds(bytes) : std::string();
        Samples out = read_frd(returns ? std::string_view(mended) : bytes, name, options, notes);
        scale(out, options);
        return out;
    }
    if (const std::string what = foreign(bytes); !what.empty()) bad(name, what);
    if (vtu) return read_vtu(bytes, name, options, notes);
    return read_csv(bytes, name, options, notes);
}

} // namespace

Samples read(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes) {
    if (bytes.empty()) throw Error(Exit::truncated, "cannot read " + name + ": it is empty");
    std::string unpacked;
    if (bytes.starts_with("\x1f\x8b")) {
        unpacked = gunzip(bytes, name);
        bytes = unpacked;
    }
    Samples out = read_any(bytes, name, options, notes);
    if (options.stress_unit == "auto") check_size(out, name);
    rename(out, options.names, name);
    return out;
}

} // namespace filum::stressfield
