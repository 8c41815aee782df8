// VTK XML of unstructured grids ("VTK File Formats", Kitware): pieces of points, cells, and arrays at the points.
#include "stressfield/elements.hpp"
#include "stressfield/formats.hpp"
#include "stressfield/vtu_array.hpp"

#include <cstring>
#include <optional>
#include <pugixml.hpp>

namespace filum::stressfield {

namespace {

// The shape of VTK's cell type; nodes come in our order, but for those of two kinds.
std::optional<Shape> shape_of(int type) {
    switch (type) {
    case 5:
        return Shape::triangle3;
    case 8: // pixel
    case 9:
        return Shape::quad4;
    case 10:
        return Shape::tet4;
    case 11: // voxel
    case 12:
        return Shape::hex8;
    case 13:
        return Shape::wedge6;
    case 14:
        return Shape::pyramid5;
    case 22:
        return Shape::triangle6;
    case 23:
        return Shape::quad8;
    case 24:
        return Shape::tet10;
    case 25:
        return Shape::hex20;
    case 26:
        return Shape::wedge15;
    default:
        return {};
    }
}

bool is_of_no_use(int type) { return type <= 4 || type == 21; } // points and lines

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 'a' - 'A');
    return text;
}

class Vtu {
  public:
    Vtu(std::string_view bytes, const std::string& name, const std::string& wanted, Notes& notes)
        : name_(name), notes_(notes) {
        for (std::size_t from = 0; !wanted.empty() && from <= wanted.size();) {
            const std::size_t end = std::min(wanted.find(',', from), wanted.size());
            wanted_.push_back(wanted.substr(from, end - from));
            from = end + 1;
        }
        parse(bytes);
    }

    Samples read() {
        const auto grid = root_.child("UnstructuredGrid");
        for (const auto& piece : grid.children("Piece")) read_piece(piece);
        if (out_.points.empty()) bad(name_, "it has no points");
        if (skipped_ > 0) notes_.push_back(note("cell of a type that is not read", skipped_));
        return std::move(out_);
    }

  private:
    // Appended data comes last and may be no XML.
    void parse(std::string_view bytes) {
        std::string_view text = bytes;
        const std::size_t appended = bytes.find("<AppendedData");
        std::string head;
        if (appended != std::string_view::npos) {
            const std::size_t tag = bytes.find('>', appended), mark = bytes.find('_', tag);
            const std::size_t end = bytes.rfind("</AppendedData");
            if (mark == std::string_view::npos || end == std::string_view::npos || end < mark)
                cut(name_, "it ends inside its appended data");
            encoding_.raw = bytes.substr(appended, tag - appended).find("raw") != std::string_view::npos;
            encoding_.appended = bytes.substr(mark + 1, end - mark - 1);
            head = std::string(bytes.substr(0, appended)) + "</VTKFile>";
            text = head;
        }
        const auto result = xml_.load_buffer(text.data(), text.size());
        if (!result && bytes.rfind("</VTKFile>") == std::string_view::npos) cut(name_, "it ends before its last tag");
        if (!result) bad(name_, std::string("it is no proper XML: ") + result.description());
        root_ = xml_.child("VTKFile");
        const std::string type = root_.attribute("type").value();
        if (type != "UnstructuredGrid")
            bad(name_, "it is VTK XML of type '" + type + "', not UnstructuredGrid; save it as .vtu");
        const std::string packer = root_.attribute("compressor").value();
        if (!packer.empty() && packer != "vtkZLibDataCompressor")
            bad(name_, "it is packed by '" + packer + "'; save it with zlib, or not packed");
        encoding_.packed = !packer.empty();
        encoding_.big_endian = std::strcmp(root_.attribute("byte_order").value(), "BigEndian") == 0;
        encoding_.wide = std::strcmp(root_.attribute("header_type").value(), "UInt64") == 0;
    }

    // The values of an array of `count` numbers; of any number of them if that is not known.
    std::vector<double> array(const pugi::xml_node& node, const std::string& what, std::optional<std::size_t> count) {
        if (!node) bad(name_, "it has no " + what);
        const Array a{node.attribute("Name").as_string(what.c_str()), node.attribute("type").value(),
                      node.attribute("format").as_string("ascii"), node.child_value(),
                      node.attribute("offset").value()};
        auto out = values(a, encoding_, name_);
        if (count && out.size() != *count)
            bad(name_, "its array '" + a.name + "' has " + std::to_string(out.size()) + " numbers, not " +
                           std::to_string(*count));
        return out;
    }

    void read_piece(const pugi::xml_node& piece) {
        const auto count = piece.attribute("NumberOfPoints").as_ullong();
        if (count == 0) return;
        const auto first = static_cast<std::uint32_t>(out_.points.size());
        if (count > (std::size_t{1} << 31)) bad(name_, "it has more points than can be");
        const auto p = array(piece.child("Points").child("DataArray"), "points", 3 * count);
        for (std::size_t i = 0; i < count; ++i) {
            out_.points.push_back({p[3 * i], p[3 * i + 1], p[3 * i + 2]});
            if (!std::isfinite(p[3 * i] + p[3 * i + 1] + p[3 * i + 2])) bad(name_, "a coordinate is not finite");
        }
        read_cells(piece, first);
        read_cases(piece, first, count);
    }

    static pugi::xml_node named(const pugi::xml_node& of, const char* name) {
        return of.find_child_by_attribute("DataArray", "Name", name);
    }

    void read_cells(const pugi::xml_node& piece, std::uint32_t first) {
        const auto cells = piece.child("Cells");
        const std::size_t count = piece.attribute("NumberOfCells").as_ullong();
        if (count == 0) return;
        const auto types = array(named(cells, "types"), "types", count);
        const auto offsets = array(named(cells, "offsets"), "offsets", count);
        const auto nodes = array(named(cells, "connectivity"), "connectivity", {});
        double from = 0;
        for (std::size_t c = 0; c < count; ++c) {
            const double to = offsets[c];
            if (!(to >= from && to <= static_cast<double>(nodes.size())))
                bad(name_, "the offsets of its cells are wrong");
            add_cell(types[c] >= 0 && types[c] <= 255 ? static_cast<int>(types[c]) : 255,
                     std::span(nodes).subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from)),
                     first);
            from = to;
        }
    }

    void add_cell(int type, std::span<const double> nodes, std::uint32_t first) {
        const auto shape = shape_of(type);
        if (!shape) {
            skipped_ += is_of_no_use(type) ? 0 : 1;
            return;
        }
        if (nodes.size() != node_count(*shape))
            bad(name_, "a cell of type " + std::to_string(type) + " has " + std::to_string(nodes.size()) + " nodes");
        out_.elements.push_back({*shape, static_cast<std::uint32_t>(out_.nodes.size())});
        const std::size_t begin = out_.nodes.size();
        for (const double n : nodes) {
            if (!(n >= 0 && n < static_cast<double>(out_.points.size() - first)))
                bad(name_, "a cell has a node that is no point");
            out_.nodes.push_back(first + static_cast<std::uint32_t>(n));
        }
        // Pixels and voxels go row by row, not round.
        if (type == 8 || type == 11) std::swap(out_.nodes[begin + 2], out_.nodes[begin + 3]);
        if (type == 11) std::swap(out_.nodes[begin + 6], out_.nodes[begin + 7]);
    }

    // How many numbers per point it has if it holds stresses, else 0.
    std::size_t width(const pugi::xml_node& a) const {
        const std::string name = a.attribute("Name").value();
        const unsigned n = a.attribute("NumberOfComponents").as_uint(1);
        if (!wanted_.empty()) {
            const bool asked = std::find(wanted_.begin(), wanted_.end(), name) != wanted_.end();
            if (asked && n != 3 && n != 6 && n != 9)
                bad(name_, "its array '" + name + "' has " + std::to_string(n) + " numbers per point, not 3, 6 or 9");
            return asked ? n : 0;
        }
        return (n == 6 || n == 9) && lower(name).find("strain") == std::string::npos ? n : 0;
    }

    void read_cases(const pugi::xml_node& piece, std::uint32_t first, std::size_t count) {
        std::size_t found = 0;
        for (const auto& a : piece.child("PointData").children("DataArray")) {
            const std::size_t n = width(a);
            if (n == 0) continue;
            if (first == 0) out_.cases.push_back({proper(a.attribute("Name").value()), {}, {}, {}});
            if (found == out_.cases.size() || out_.cases[found].name != proper(a.attribute("Name").value()))
                bad(name_, "its pieces do not have the same arrays");
            add_values(out_.cases[found++], array(a, "stresses", n * count), n);
        }
        if (found < std::max<std::size_t>({1, wanted_.size(), out_.cases.size()})) nothing_found(piece);
    }

    static std::string proper(std::string name) {
        for (char& c : name)
            if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')) c = '-';
        return name;
    }

    static void add_values(Case& c, const std::vector<double>& v, std::size_t n) {
        const double unknown = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < v.size(); i += n) {
            const double* t = v.data() + i;
            if (n == 6) c.tensors.push_back({t[0], t[1], t[2], t[3], t[4], t[5]});
            if (n == 9)
                c.tensors.push_back({t[0], t[4], t[8], (t[1] + t[3]) / 2, (t[5] + t[7]) / 2, (t[2] + t[6]) / 2});
            if (n != 3) continue;
            const Vec3 d{t[0], t[1], t[2]};
            c.principals.push_back({norm(d), unknown, unknown});
            c.directions.push_back(d);
        }
    }

    [[noreturn]] void nothing_found(const pugi::xml_node& piece) const {
        if (!wanted_.empty()) {
            std::string names;
            for (const auto& a : piece.child("PointData").children("DataArray"))
                names += (names.empty() ? "'" : ", '") + std::string(a.attribute("Name").value()) + "'";
            throw Error(Exit::usage, "cannot find all of --columns in " + name_ + "; its points have " +
                                         (names.empty() ? "no arrays" : names));
        }
        for (const auto& a : piece.child("CellData").children("DataArray"))
            if (width(a) > 0) bad(name_, "its stresses belong to cells; turn them into data of points");
        bad(name_, "it has no array of 6 or 9 numbers per point; name one of vectors by --columns");
    }

    const std::string& name_;
    Notes& notes_;
    std::vector<std::string> wanted_;
    pugi::xml_document xml_;
    pugi::xml_node root_;
    Encoding encoding_;
    std::size_t skipped_ = 0;
    Samples out_;
};

} // namespace

Samples read_vtu(std::string_view bytes, const std::string& name, const std::string& arrays, Notes& notes) {
    return Vtu(bytes, name, arrays, notes).read();
}

} // namespace filum::stressfield
