// Files as many programs write them: any order, naming and layout of components gives the tensors that were written, or
// a refusal; and what is named plainly is not refused.
#include "refusal.hpp"
#include "stressfield/read.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace filum::stressfield {
namespace orders {
namespace {

constexpr const char* kPairs[] = {"xx", "yy", "zz", "xy", "yz", "zx"};

int tries() {
    const char* const n = std::getenv("FILUM_STRESS_TRIES");
    return n != nullptr ? std::atoi(n) : 2000;
}

class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    template <class T>
    const T& of(const std::vector<T>& v) {
        return v[static_cast<std::size_t>(below(static_cast<int>(v.size())))];
    }
    std::vector<int> shuffled(int n) {
        std::vector<int> out;
        for (int i = 0; i < n; ++i) out.insert(out.begin() + below(i + 1), i);
        return out;
    }

  private:
    std::mt19937 engine_;
};

std::string upper(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

// The name of entry `e` of a tensor in one of the ways of programs; `flip` writes yx for xy.
std::string component_name(int style, int e, bool flip) {
    std::string pair = kPairs[e];
    if (flip) std::swap(pair[0], pair[1]);
    std::string digits;
    for (const char c : pair) digits += static_cast<char>('1' + (c - 'x'));
    const std::string one = pair[0] == pair[1] ? pair.substr(0, 1) : pair;
    switch (style) {
    case 0:
        return upper(pair); // VTK, ParaView
    case 1:
        return pair; // ccx2paraview
    case 2:
        return "S" + upper(pair); // CalculiX
    case 3:
        return "S" + digits; // Abaqus
    case 4:
        return "S-S" + digits; // Abaqus, as CSV
    case 5:
        return "SI" + upper(pair); // Code_Aster
    case 6:
        return "stress_" + pair; // MOOSE
    case 7:
        return "S" + upper(one); // Ansys
    case 8:
        return "Stress " + upper(pair);
    case 9:
        return "\xcf\x83_" + pair; // Greek sigma
    case 10:
        return "S(" + pair + ")";
    case 11:
        return "sigma_" + digits;
    default:
        return digits;
    }
}
constexpr int kStyles = 13;

using Field = std::vector<Tensor>;

Field random_field(Dice& dice) {
    Field out(5);
    for (auto& t : out)
        for (double& v : t) v = (dice.below(20001) - 10000) / 64.0;
    return out;
}

std::string number(double v) {
    char out[64];
    std::snprintf(out, sizeof out, "%.10g", v);
    return out;
}

struct Attempt {
    std::string text;
    ReadOptions options;
    bool must_be_read = false;
    double factor = 1; // of the numbers in the file to MPa
};

void expect_truth(const Attempt& a, const Field& truth, int seed) {
    Notes notes;
    Samples s;
    try {
        s = read(a.text, "it", a.options, notes);
    } catch (const Error& e) {
        EXPECT_TRUE(e.exit() == Exit::bad_input || e.exit() == Exit::usage) << seed << e.what();
        EXPECT_FALSE(a.must_be_read) << "seed " << seed << ": " << e.what() << "\n" << a.text;
        return;
    }
    ASSERT_EQ(s.cases.size(), 1U) << "seed " << seed << "\n" << a.text;
    ASSERT_EQ(s.cases[0].tensors.size(), truth.size()) << "seed " << seed;
    EXPECT_FALSE(s.cases[0].origin.empty());
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (std::size_t k = 0; k < 6; ++k)
            ASSERT_NEAR(s.cases[0].tensors[i][k], a.factor * truth[i][k], 1e-6 * a.factor * 200)
                << "seed " << seed << " point " << i << " " << kPairs[k] << "\n"
                << a.text;
}

constexpr const char* kGridEnd =
    "</PointData>\n<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n"
    "0 0 0 1 0 0 0 1 0 0 0 1 1 1 1\n</DataArray>\n</Points>\n<Cells/>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

std::string data_array(const std::string& name, const std::vector<std::string>& components,
                       const std::vector<std::vector<double>>& rows) {
    std::string out = "<DataArray type=\"Float64\" Name=\"" + name + "\" NumberOfComponents=\"" +
                      std::to_string(rows[0].size()) + "\"";
    for (std::size_t k = 0; k < components.size(); ++k)
        if (!components[k].empty()) out += " ComponentName" + std::to_string(k) + "=\"" + components[k] + "\"";
    out += " format=\"ascii\">\n";
    for (const auto& row : rows)
        for (const double v : row) out += number(v) + " ";
    return out + "\n</DataArray>\n";
}

std::vector<std::vector<double>> rows_of(const Field& field, const std::vector<int>& order) {
    std::vector<std::vector<double>> out;
    for (const Tensor& t : field) {
        out.emplace_back();
        for (const int e : order) out.back().push_back(e < 0 ? 7777 : t[static_cast<std::size_t>(e)]);
    }
    return out;
}

// Six numbers or nine, named or not, whole or as six arrays; with strains beside them.
Attempt random_vtu(Dice& dice, const Field& truth, int seed) {
    Attempt out;
    const int style = dice.below(kStyles), layout = dice.below(5);
    const bool named = layout == 3 || !dice.one_in(3);
    std::vector<int> order = dice.shuffled(6);
    if (!named) order = dice.one_in(2) ? std::vector<int>{0, 1, 2, 3, 4, 5} : std::vector<int>{0, 1, 2, 3, 5, 4};
    std::vector<std::string> names;
    const bool flip = dice.one_in(2);
    for (const int e : order) names.push_back(component_name(style, e, flip));
    if (layout == 2) { // nine
        constexpr int kNine[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};
        order.clear();
        names.clear();
        for (const int at : named ? dice.shuffled(9) : std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8}) {
            order.push_back(kNine[at]);
            names.push_back(component_name(style, kNine[at], at == 3 || at == 6 || at == 7));
        }
    }
    if (layout == 4 && named) { // a number more
        order.push_back(-1);
        names.emplace_back("Mises");
    }
    const std::string array = dice.of(std::vector<std::string>{"S", "stress", "Nodal Stress", "sigma", "SIEF_NOEU",
                                                               "CAUCHY_STRESS_VECTOR", "Stress [Pa]", "S_1", "STRESS"});
    std::string body;
    const auto strain = [&] {
        Field e = truth;
        for (auto& t : e)
            for (double& v : t) v *= 1e-5;
        const std::string name = dice.of(
            std::vector<std::string>{"E", "strain", "TOSTRAIN", "EPSI_NOEU", "LE", "Elastic Strain", "epsilon"});
        return data_array(name, {}, rows_of(e, {0, 1, 2, 3, 4, 5}));
    };
    if (dice.one_in(3)) body += strain();
    if (layout == 3) {
        const auto rows = rows_of(truth, order);
        for (std::size_t k = 0; k < order.size(); ++k) {
            std::vector<std::vector<double>> column;
            for (const auto& row : rows) column.push_back({row[k]});
            body += data_array(names[k], {}, column);
        }
        out.must_be_read = style >= 2 && style <= 11;
    } else {
        if (!named) names.clear();
        body += data_array(array, names, rows_of(truth, order));
        const bool vtk = order[4] == 4 || layout == 2;
        out.must_be_read = named || vtk;
        if (!named && !vtk) out.options.order = "abaqus";
        if (array == "Stress [Pa]") out.factor = 1e-6;
    }
    if (dice.one_in(3)) body += strain();
    out.text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"5\" "
               "NumberOfCells=\"0\">\n<PointData>\n" +
               body + kGridEnd;
    (void)seed;
    return out;
}

struct UnitText {
    const char* text;
    double factor;
};

// A number in one of the ways of spreadsheets.
std::string cell(double v, bool comma, bool quote, bool groups) {
    char out[64];
    std::snprintf(out, sizeof out, "%.7f", v);
    std::string text = out;
    if (groups) {
        const std::size_t first = text.find_first_of("0123456789");
        for (std::size_t at = text.find('.'); at > first + 3; at -= 3) text.insert(at - 3, comma ? "." : ",");
    }
    if (comma) text[text.rfind('.')] = ','; // groups come before it
    return quote ? "\"" + text + "\"" : text;
}

Attempt random_csv(Dice& dice, const Field& truth, int) {
    Attempt out;
    out.must_be_read = true;
    int style = dice.below(kStyles);
    if (style < 2 || style == 12) style = 2; // "XX" does not say of what
    const char mark = dice.of(std::vector<char>{',', ';', '\t'});
    const bool comma = dice.one_in(3), quote = (comma && mark == ',') || dice.one_in(3);
    const bool groups = dice.one_in(4) && (quote || mark != ',');
    const std::string end = dice.of(std::vector<std::string>{"\n", "\r\n", "\r"});
    const UnitText unit = dice.of(std::vector<UnitText>{{"", 1},
                                                        {"MPa", 1},
                                                        {"Pa", 1e-6},
                                                        {"psi", 0.006894757293168361},
                                                        {"ksi", 6.894757293168361},
                                                        {"GPa", 1e3},
                                                        {"N/mm^2", 1}});
    out.factor = unit.factor;
    const int brackets = dice.below(3);
    const auto with_unit = [&](const std::string& name, const std::string& u) {
        const std::string text = u.empty()       ? name
                                 : brackets == 0 ? name + " [" + u + "]"
                                 : brackets == 1 ? name + " (" + u + ")"
                                                 : name + "_" + u;
        return quote || dice.one_in(4) ? "\"" + text + "\"" : text;
    };
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows(truth.size());
    const auto column = [&](const std::string& name, const auto& value) {
        header.push_back(name);
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(value(i));
    };
    const bool text_columns = dice.one_in(2);
    if (text_columns) {
        column("ODB Name", [](std::size_t) { return "a.odb"; });
        column("Step", [](std::size_t) { return "Step-1"; });
        column("Node Label", [](std::size_t i) { return std::to_string(i); });
    }
    for (const int c : dice.shuffled(3))
        column(with_unit(std::string(1, static_cast<char>('X' + c)), unit.text[0] == '\0' ? "" : "mm"),
               [&](std::size_t i) {
                   return cell(c == 0 ? 1.5 * static_cast<double>(i) : c == 1 ? 0.25 : 0, comma, quote, groups);
               });
    for (const int e : dice.shuffled(6))
        column(with_unit(component_name(style, e, false), unit.text),
               [&](std::size_t i) { return cell(100 * truth[i][static_cast<std::size_t>(e)], comma, quote, groups); });
    out.factor *= 100;
    if (dice.one_in(2)) column("S, Mises", [](std::size_t) { return "1"; });
    if (header.back() == "S, Mises") header.back() = "\"S, Mises\"";
    if (dice.one_in(8)) { // wider than the header: must not be read
        for (auto& row : rows) row.insert(row.begin(), "7");
        out.must_be_read = false;
    }
    const auto line = [&](const std::vector<std::string>& cells) {
        for (std::size_t k = 0; k < cells.size(); ++k) out.text += (k == 0 ? "" : std::string(1, mark)) + cells[k];
        out.text += end;
    };
    line(header);
    for (const auto& row : rows) line(row);
    return out;
}

TEST(Orders, EveryOrderNamingAndLayoutOfAVtuGivesTheTruth) {
    for (int seed = 0; seed < tries() && !::testing::Test::HasFailure(); ++seed) {
        Dice dice(static_cast<unsigned>(seed));
        const Field truth = random_field(dice);
        expect_truth(random_vtu(dice, truth, seed), truth, seed);
    }
}

TEST(Orders, EveryTableGivesTheTruth) {
    for (int seed = 0; seed < tries() && !::testing::Test::HasFailure(); ++seed) {
        Dice dice(static_cast<unsigned>(seed) + 1000000);
        const Field truth = random_field(dice);
        expect_truth(random_csv(dice, truth, seed), truth, seed);
    }
}

} // namespace
} // namespace orders
} // namespace filum::stressfield
