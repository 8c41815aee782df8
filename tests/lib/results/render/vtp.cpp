// VTP files hold what was drawn, number for number.
#include "render/vtp.hpp"
#include "render/draw.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace filum::render {

namespace {

// The numbers of the array of that name, read by the format's rules.
template <class T>
std::vector<T> array(const std::string& file, const std::string& name) {
    const auto at = file.find("Name=\"" + name + "\"");
    if (at == std::string::npos) return {};
    const auto begin = file.find('>', at) + 1, end = file.find('<', begin);
    std::string bytes;
    std::uint32_t bits = 0;
    int held = 0;
    for (auto i = begin; i < end && file[i] != '='; ++i) {
        const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        bits = bits << 6 | static_cast<std::uint32_t>(std::strchr(digits, file[i]) - digits);
        held += 6;
        if (held >= 8) bytes += static_cast<char>(bits >> (held -= 8) & 255);
    }
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    EXPECT_EQ(size + sizeof size, bytes.size()) << name;
    std::vector<T> out(size / sizeof(T));
    if (size > 0) std::memcpy(out.data(), bytes.data() + sizeof size, size);
    return out;
}

Scene two_spans() {
    Scene s;
    s.spans.push_back({toolpath::Role::hairpin, 3, 1, 7, {{0, 0, 0}, {3, 4, 0}, {3, 4, 2}}, {0.5}, {0.2, 0.3, 0.4}});
    s.spans.back().normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    s.spans.push_back({toolpath::Role::travel, 4, 1, 7, {{3, 4, 2}, {1, 1, 1}}, {}, {}});
    return s;
}

TEST(Vtp, HoldsTheSpans) {
    const std::string file = vtp(two_spans());
    using D = std::vector<double>;
    EXPECT_EQ(array<double>(file, "points"), (D{0, 0, 0, 3, 4, 0, 3, 4, 2, 3, 4, 2, 1, 1, 1}));
    EXPECT_EQ(array<double>(file, "normal"), (D{0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(array<double>(file, "width"), (D{0.5, 0.5, 0.5, 0, 0}));
    EXPECT_EQ(array<double>(file, "height"), (D{0.2, 0.3, 0.4, 0, 0}));
    EXPECT_EQ(array<double>(file, "progress"), (D{0, 5, 7, 7, 7}));
    EXPECT_EQ(array<std::uint8_t>(file, "role"), (std::vector<std::uint8_t>{5, 4}));
    EXPECT_EQ(array<std::uint32_t>(file, "stroke"), (std::vector<std::uint32_t>{3, 4}));
    EXPECT_EQ(array<std::int64_t>(file, "connectivity"), (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
    EXPECT_EQ(array<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{3, 5}));
    EXPECT_NE(file.find("NumberOfPoints=\"5\""), std::string::npos);
    EXPECT_NE(file.find("NumberOfLines=\"2\""), std::string::npos);
    EXPECT_NE(file.find("4 travel 5 hairpin"), std::string::npos);
}

TEST(Vtp, HoldsTheSurfaceAndItsFields) {
    Notes notes;
    Scene s;
    s.sheet =
        surface::Sheet{surface::connect({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}}, notes),
                       {{"distance", {0, 1, INFINITY, 1}, 1}, {"a<\"b\"&c", {1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0}, 3}},
                       {}};
    const std::string file = vtp(s);
    EXPECT_EQ(array<double>(file, "distance"), s.sheet->fields[0].values);
    EXPECT_EQ(array<double>(file, "a&#60;&#34;b&#34;&#38;c"), s.sheet->fields[1].values);
    EXPECT_EQ(array<std::int64_t>(file, "connectivity"), (std::vector<std::int64_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(array<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{3, 6}));
    EXPECT_NE(file.find("NumberOfPolys=\"2\""), std::string::npos);
}

TEST(Vtp, IsNotForOutlines) {
    Scene s;
    s.outlines.push_back({});
    Options o;
    o.vtp = true;
    EXPECT_THROW(draw(s, o, "layer", 1), Error);
}

} // namespace

} // namespace filum::render
