// VTK XML of unstructured grids ("VTK File Formats", Kitware): pieces of points, cells, and arrays at the points.
#include "stressfield/elements.hpp"
#include "stressfield/formats.hpp"
#include "stressfield/units.hpp"
#include "stressfield/vtu_array.hpp"
#include "stressfield/vtu_cases.hpp"

#include <cstring>
#include <optional>
#include <pugixml.hpp>

namespace filum::stressfield {

namespace {

// The shape of VTK's cell type. The order of nodes is that of Shape, except for two types.
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

class VtuReader {
  public:
    VtuReader(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes)
        : name_(name), options_(options), notes_(notes) {
        parse(bytes);
    }

    Samples read() {
        const auto grid = root_.child("UnstructuredGrid");
        for (const auto& piece : grid.children("Piece")) read_piece(piece);
        if (out_.points.empty()) bad(name_, "it has no points");
        scale_points();
        if (skipped_ > 0) notes_.push_back(note(NoteCode::vtu_cell_unknown, skipped_));
        return std::move(out_);
    }

  private:
    // Appended data comes last and need not be XML.
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
        if (bytes.substr(0, bytes.find("<Piece")).find("created by meshio") != std::string_view::npos)
            writer_ = "meshio";
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

    // The values of an array of `count` numbers; of any number if that is unknown.
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
        read_cases(piece, count);
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
        // Nodes of pixels and voxels are in rows, not around the face.
        if (type == 8 || type == 11) std::swap(out_.nodes[begin + 2], out_.nodes[begin + 3]);
        if (type == 11) std::swap(out_.nodes[begin + 6], out_.nodes[begin + 7]);
    }

    static ArrayHead head_of(const pugi::xml_node& a) {
        ArrayHead out{a.attribute("Name").value(), a.attribute("NumberOfComponents").as_uint(1), {}};
        for (std::size_t k = 0; k < out.width && out.width <= kMostComponents; ++k) {
            const auto name = a.attribute(("ComponentName" + std::to_string(k)).c_str());
            if (name || !out.components.empty()) out.components.resize(k);
            if (name) out.components.emplace_back(name.value());
        }
        if (!out.components.empty()) out.components.resize(out.width);
        return out;
    }

    void read_cases(const pugi::xml_node& piece, std::size_t count) {
        std::vector<ArrayHead> heads;
        for (const auto& a : piece.child("PointData").children("DataArray")) heads.push_back(head_of(a));
        if (sources_.empty()) {
            sources_ = cases_of(heads, options_, writer_, name_, notes_);
            if (sources_.empty()) nothing_found(piece);
            heads_ = heads;
            for (const auto& s : sources_) out_.cases.push_back({s.name, {}, {}, {}, ""});
        }
        if (heads != heads_) bad(name_, "its pieces do not have the same arrays");
        for (std::size_t k = 0; k < sources_.size(); ++k) add_values(piece, k, count);
    }

    // All numbers of a load case, point by point.
    std::vector<double> numbers_of(const pugi::xml_node& piece, const CaseSource& source, std::size_t count) {
        const auto point_data = piece.child("PointData");
        const auto all = [&](const std::string& name) {
            return array(named(point_data, name.c_str()), "stresses", source.width * count);
        };
        if (source.arrays.size() == 1) return all(source.arrays.front());
        std::vector<double> out(source.arrays.size() * count);
        for (std::size_t k = 0; k < source.arrays.size(); ++k) {
            const auto own = all(source.arrays[k]);
            for (std::size_t i = 0; i < count; ++i) out[i * source.arrays.size() + k] = own[i];
        }
        return out;
    }

    void add_values(const pugi::xml_node& piece, std::size_t k, std::size_t count) {
        const CaseSource& source = sources_[k];
        Case& c = out_.cases[k];
        const auto v = numbers_of(piece, source, count);
        c.origin = origin(source);
        c.unit_named = source.unit_named;
        if (source.order.empty()) {
            const double unknown = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < count; ++i) {
                const Vec3 d = source.factor * Vec3{v[3 * i], v[3 * i + 1], v[3 * i + 2]};
                c.principals.push_back({norm(d), unknown, unknown});
                c.directions.push_back(d);
            }
            return;
        }
        check_symmetry(source, v);
        std::array<double, 6> share{};
        for (const int entry : source.order)
            if (entry != kUnused) ++share[static_cast<std::size_t>(entry)];
        const std::size_t n = source.order.size();
        for (std::size_t i = 0; i < count; ++i) {
            Tensor t{};
            for (std::size_t j = 0; j < n; ++j)
                if (const int entry = source.order[j]; entry != kUnused)
                    t[static_cast<std::size_t>(entry)] +=
                        source.factor * v[i * n + j] / share[static_cast<std::size_t>(entry)];
            c.tensors.push_back(t);
        }
    }

    // Of nine numbers, xy must equal yx: otherwise their order is different, or they are not a Cauchy stress.
    void check_symmetry(const CaseSource& source, const std::vector<double>& v) const {
        if (source.both_halves) return;
        const std::size_t n = source.order.size();
        double largest = 0, apart = 0;
        for (std::size_t i = 0; i < v.size(); i += n) {
            std::array<double, 6> first{};
            std::array<bool, 6> there{};
            for (std::size_t j = 0; j < n; ++j) {
                if (source.order[j] == kUnused) continue;
                const auto entry = static_cast<std::size_t>(source.order[j]);
                largest = std::max(largest, std::abs(v[i + j]));
                if (there[entry]) apart = std::max(apart, std::abs(v[i + j] - first[entry]));
                first[entry] = v[i + j];
                there[entry] = true;
            }
        }
        if (apart > kAsymmetry * largest)
            bad(name_, "the tensors of its array '" + source.arrays.front() +
                           "' are not symmetric, so they are no stresses in the order " + text_of(source.order) +
                           "; give --order");
    }

    static std::string origin(const CaseSource& source) {
        std::string names;
        for (const auto& a : source.arrays) names += (names.empty() ? "" : "+") + a;
        return names + ": " +
               (source.order.empty() ? "vector" : text_of(source.order) + (source.assumed ? " (assumed)" : "")) + ", " +
               source.unit;
    }

    void scale_points() {
        const double factor = options_.unit == "auto" ? 1 : *factor_of(Dimension::length, options_.unit);
        for (Vec3& p : out_.points) p = factor * p;
    }

    [[noreturn]] void nothing_found(const pugi::xml_node& piece) const {
        if (!options_.columns.empty()) {
            std::string names;
            for (const auto& a : piece.child("PointData").children("DataArray"))
                names += (names.empty() ? "'" : ", '") + std::string(a.attribute("Name").value()) + "'";
            throw Error(Exit::usage, "cannot find all of --columns in " + name_ + "; its points have " +
                                         (names.empty() ? "no arrays" : names));
        }
        for (const auto& a : piece.child("CellData").children("DataArray"))
            if (const auto head = head_of(a); quantity_of(head.name) == Quantity::stress || head.width == 6)
                bad(name_, "its stresses belong to cells; turn them into data of points");
        bad(name_, "it has no array of 6 or 9 numbers per point that holds stresses; name one of vectors by --columns");
    }

    static constexpr std::size_t kMostComponents = 64; // per point: names of larger arrays are not read
    // fraction of the largest component: more than the rounding error of four digits of text
    static constexpr double kAsymmetry = 1e-3;

    const std::string& name_;
    const ReadOptions& options_;
    Notes& notes_;
    std::string writer_; // a program that keeps any order of components; "": unknown
    std::vector<ArrayHead> heads_;
    std::vector<CaseSource> sources_;
    pugi::xml_document xml_;
    pugi::xml_node root_;
    Encoding encoding_;
    std::size_t skipped_ = 0;
    Samples out_;
};

} // namespace

Samples read_vtu(std::string_view bytes, const std::string& name, const ReadOptions& options, Notes& notes) {
    return VtuReader(bytes, name, options, notes).read();
}

} // namespace filum::stressfield
