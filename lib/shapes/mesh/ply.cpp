// Reads PLY: a text header that describes elements (vertex, face, others) and their properties, then the values, as
// text or as binary of either byte order. Other elements and properties are skipped; only their size matters.
#include "base/error.hpp"
#include "mesh/formats.hpp"
#include "mesh/polygons.hpp"
#include "mesh/text.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

namespace filum::mesh {

namespace {

enum class Type : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };
constexpr std::size_t kSize[] = {1, 1, 2, 2, 4, 4, 4, 8};

struct Property {
    std::string name;
    Type type = Type::f32;
    std::optional<Type> count; // type of a list's length
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding : std::uint8_t { text, little, big };

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
};

[[noreturn]] void malformed(const std::string& name, const std::string& why) {
    throw Error(Exit::bad_input, "cannot read " + name + ": " + why);
}
[[noreturn]] void cut(const std::string& name) {
    throw Error(Exit::truncated, "cannot read " + name + ": it ends before the last element that its header announces");
}

Type type(std::string_view word, const std::string& name) {
    constexpr std::pair<std::string_view, Type> kNames[] = {
        {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
        {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
        {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
        {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
    for (const auto& [text, t] : kNames)
        if (word == text) return t;
    malformed(name, "its header has a property of unknown type '" + std::string(word.substr(0, 20)) + "'");
}

Encoding encoding(std::string_view word, const std::string& name) {
    if (word == "ascii") return Encoding::text;
    if (word == "binary_little_endian") return Encoding::little;
    if (word == "binary_big_endian") return Encoding::big;
    malformed(name, "its header names the unknown format '" + std::string(word.substr(0, 30)) + "'");
}

Property property(Text& text, const std::string& name) {
    Property p;
    std::string_view word = text.word();
    if (word == "list") {
        p.count = type(text.word(), name);
        if (*p.count == Type::f32 || *p.count == Type::f64)
            malformed(name, "its header has a list whose length is no whole number");
        word = text.word();
    }
    p.type = type(word, name);
    p.name = text.word();
    return p;
}

// Skips the line end behind the header. If lines end with CR alone, a byte of data after it may look like an LF. So the
// first line of the file decides how lines end.
void pass_header_end(Text& text) {
    const char* first = std::find_if(text.begin, text.end, is_line_end);
    const bool two = text.end - first > 1 && first[0] == '\r' && first[1] == '\n';
    if (two)
        text.pass_line_end();
    else if (text.at < text.end)
        ++text.at;
}

Header header(Text& text, const std::string& name) {
    Header out;
    while (text.more()) {
        const std::string_view word = text.word();
        if (word == "end_header") {
            text.skip_line();
            pass_header_end(text);
            return out;
        }
        if (word == "format")
            out.encoding = encoding(text.word(), name);
        else if (word == "element") {
            Element e;
            e.name = text.word();
            long long n = -1;
            if (!text.more_on_line() || !text.whole(n) || n < 0)
                malformed(name, "its header has an element without a count");
            e.count = static_cast<std::uint64_t>(n);
            out.elements.push_back(std::move(e));
        } else if (word == "property") {
            if (out.elements.empty()) malformed(name, "its header has a property before the first element");
            out.elements.back().properties.push_back(property(text, name));
        }
        text.skip_line();
    }
    throw Error(Exit::truncated, "cannot read " + name + ": it ends inside its header");
}

// Reads values one after the other, in any encoding.
class Values {
  public:
    Values(Text text, Encoding encoding, const std::string& name) : text_(text), encoding_(encoding), name_(name) {}

    [[nodiscard]] std::uint64_t bytes_left() const { return static_cast<std::uint64_t>(text_.end - text_.at); }
    [[nodiscard]] std::size_t least_size(Type t) const {
        return encoding_ == Encoding::text ? 1 : kSize[static_cast<std::size_t>(t)];
    }

    double next(Type t) {
        if (encoding_ == Encoding::text) {
            double v = 0;
            if (!text_.more()) cut(name_);
            if (!text_.number(v))
                malformed(name_, "line " + std::to_string(text_.line()) + " has something that is no number");
            return v;
        }
        switch (t) {
        case Type::i8:
            return raw<std::int8_t>();
        case Type::u8:
            return raw<std::uint8_t>();
        case Type::i16:
            return raw<std::int16_t>();
        case Type::u16:
            return raw<std::uint16_t>();
        case Type::i32:
            return raw<std::int32_t>();
        case Type::u32:
            return raw<std::uint32_t>();
        case Type::f32:
            return raw<float>();
        case Type::f64:
            return raw<double>();
        }
        return 0;
    }

    // Reads the length of a list of `t`.  Throws if the file cannot hold that many values.
    std::uint64_t length(const Property& p) {
        const double n = next(*p.count);
        if (!(n >= 0)) malformed(name_, "it has a list of negative length");
        if (n * static_cast<double>(least_size(p.type)) > static_cast<double>(bytes_left())) cut(name_);
        return static_cast<std::uint64_t>(n);
    }

    // The number of bytes left after the last value, not counting blanks.
    [[nodiscard]] std::uint64_t bytes_behind() {
        if (encoding_ == Encoding::text) text_.more();
        return bytes_left();
    }

  private:
    template <class T>
    T raw() {
        if (bytes_left() < sizeof(T)) cut(name_);
        unsigned char b[sizeof(T)];
        std::memcpy(b, text_.at, sizeof(T));
        text_.at += sizeof(T);
        if ((encoding_ == Encoding::big) == (std::endian::native == std::endian::little))
            std::reverse(b, b + sizeof(T));
        T v;
        std::memcpy(&v, b, sizeof(T));
        return v;
    }
    Text text_;
    Encoding encoding_;
    const std::string& name_;
};

void skip(Values& values, const Property& p) {
    const std::uint64_t n = p.count ? values.length(p) : 1;
    for (std::uint64_t i = 0; i < n; ++i) values.next(p.type);
}

void read_vertices(Values& values, const Element& e, const std::string& name, std::vector<Vec3>& out) {
    std::vector<double Vec3::*> to(e.properties.size(), nullptr);
    int found = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
        const Property& p = e.properties[i];
        if (p.count || p.name.size() != 1) continue;
        to[i] = p.name == "x" ? &Vec3::x : p.name == "y" ? &Vec3::y : p.name == "z" ? &Vec3::z : nullptr;
        found += to[i] != nullptr ? 1 : 0;
    }
    if (found != 3) malformed(name, "its vertices lack x, y or z");
    out.reserve(e.count);
    for (std::uint64_t i = 0; i < e.count; ++i) {
        Vec3 v;
        for (std::size_t k = 0; k < to.size(); ++k) {
            if (to[k] == nullptr)
                skip(values, e.properties[k]);
            else
                v.*to[k] = values.next(e.properties[k].type);
        }
        out.push_back(v);
    }
}

void read_faces(Values& values, const Element& e, const std::string& name, Faces& out) {
    const auto is_index = [](const Property& p) {
        return p.count && (p.name == "vertex_indices" || p.name == "vertex_index");
    };
    if (std::count_if(e.properties.begin(), e.properties.end(), is_index) != 1)
        malformed(name, "its faces have no list 'vertex_indices'");
    std::vector<std::uint32_t> corners;
    for (std::uint64_t i = 0; i < e.count; ++i)
        for (const Property& p : e.properties) {
            if (!is_index(p)) {
                skip(values, p);
                continue;
            }
            corners.clear();
            for (std::uint64_t k = values.length(p); k > 0; --k) {
                const double v = values.next(p.type);
                if (!(v >= 0 && v < 4294967295.0)) malformed(name, "a face has a corner that is no vertex");
                corners.push_back(static_cast<std::uint32_t>(v));
            }
            out.add(corners);
        }
}

} // namespace

Mesh read_ply(std::string_view bytes, const std::string& name, Notes& notes) {
    Text text(bytes);
    text.word();
    const Header head = header(text, name);
    Values values(text, head.encoding, name);
    Mesh out;
    Faces faces;
    bool strips = false;
    for (const Element& e : head.elements) {
        std::uint64_t least = 0;
        for (const Property& p : e.properties) least += values.least_size(p.count.value_or(p.type));
        if (least == 0) continue; // it takes no bytes in the file
        if (e.count > values.bytes_left() / least + 1) cut(name);
        strips = strips || e.name == "tristrips";
        if (e.name == "vertex")
            read_vertices(values, e, name, out.vertices);
        else if (e.name == "face")
            read_faces(values, e, name, faces);
        else
            for (std::uint64_t i = 0; i < e.count; ++i)
                for (const Property& p : e.properties) skip(values, p);
    }
    if (const std::uint64_t behind = values.bytes_behind(); behind > 0)
        notes.push_back(note(NoteCode::trailing_bytes, static_cast<double>(behind)));
    if (strips && faces.triangles.empty()) malformed(name, "it holds triangle strips; export it with faces");
    for (const Triangle& t : faces.triangles)
        for (const std::uint32_t v : t)
            if (v >= out.vertices.size()) malformed(name, "a face has a corner that is no vertex");
    faces.cut(out.vertices, notes);
    out.triangles = std::move(faces.triangles);
    return out;
}

} // namespace filum::mesh
