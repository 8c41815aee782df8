#include "app/filum/printers.hpp"

#include "../files.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace filum::app::filum {
namespace {

constexpr const char* kVendor = "[printer:*base*]\nnozzle_diameter = 0.4\ndefault_print_profile = usual\n"
                                "[printer:Maker One]\ninherits = *base*\n"
                                "[printer:Maker One 0.6]\ninherits = *base*\nnozzle_diameter = 0.6\n"
                                "[printer:Maker Two XL]\ninherits = *base*\n[printer:Maker Two XS]\ninherits = *base*\n"
                                "[print:usual]\nperimeters = 4\nlayer_height = 0.2\n"
                                "[filament:Fine PLA]\ntemperature = 203\n";

std::string value_in(const ChosenPrinter& chosen, const std::string& key) {
    std::string out = "-";
    for (const SlicerFile& file : chosen.settings)
        for (const SlicerSetting& s : file.settings)
            if (s.key == key) out = s.value;
    return out;
}

class Printers : public testing::Test {
  protected:
    Printers() {
        static_cast<void>(at_.write("Maker.ini", kVendor));
        ::setenv("FILUM_PRESETS", at_("").c_str(), 1);
    }
    ~Printers() override { ::unsetenv("FILUM_PRESETS"); }

    test::Folder at_;
};

TEST_F(Printers, WordsChooseTheOneThatHoldsThemAll) {
    EXPECT_EQ(value_in(chosen_printer({"Maker One 0.6", "", ""}), "nozzle_diameter"), "0.6");
    const ChosenPrinter one = chosen_printer({"maker one", "", ""}); // of variants the shortest name
    EXPECT_EQ(value_in(one, "nozzle_diameter"), "0.4");
    EXPECT_EQ(value_in(one, "perimeters"), "4");
    EXPECT_EQ(value_in(chosen_printer({"maker xs", "", ""}), "nozzle_diameter"), "0.4");
    EXPECT_THROW(chosen_printer({"maker two", "", ""}), Error); // either of two
    EXPECT_THROW(chosen_printer({"no such machine", "", ""}), Error);
}

TEST_F(Printers, FilamentsAreThoseOfPresetsAndFourCommonOnes) {
    EXPECT_EQ(value_in(chosen_printer({"Maker One", "", "Fine PLA"}), "temperature"), "203");
    EXPECT_EQ(value_in(chosen_printer({"Maker One", "", "PETG"}), "temperature"), "240");
    EXPECT_EQ(value_in(chosen_printer({"", "", "abs"}), "first_layer_bed_temperature"), "100");
    EXPECT_THROW(chosen_printer({"", "", "wood"}), Error);
}

// As OrcaSlicer selects them: a default that is missing or for other nozzles gives way to the first one for the
// printer.
TEST_F(Printers, ADefaultForOtherPrintersIsReplaced) {
    for (const char* folder : {"V/machine", "V/process", "V/filament"})
        std::filesystem::create_directories(at_(folder));
    const auto put = [&](const std::string& name, const std::string& json) {
        static_cast<void>(at_.write(name, json));
    };
    const auto process = [&](const std::string& name, const std::string& printer, const char* loops) {
        put("V/process/" + name + ".json", R"({"type": "process", "name": ")" + name +
                                               R"(", "instantiation": "true", "wall_loops": ")" + loops +
                                               R"(", "compatible_printers": [")" + printer + R"("]})");
    };
    process("a coarse", "Vee 0.8", "7");
    process("b fine", "Vee 0.4", "5");
    process("c fine", "Vee 0.4", "6");
    for (const char* usual : {"a coarse", "no such", "b fine", "c fine"}) {
        put("V/machine/Vee 0.4.json", R"({"type": "machine", "name": "Vee 0.4", "instantiation": "true",
            "printable_area": ["0x0", "9x0", "9x9", "0x9"], "nozzle_diameter": ["0.4"],
            "default_print_profile": ")" + std::string(usual) +
                                          R"("})");
        const ChosenPrinter chosen = chosen_printer({"Vee 0.4", "", ""});
        const bool own = std::string(usual).ends_with("fine");
        EXPECT_EQ(value_in(chosen, "wall_loops"), std::string(usual) == "c fine" ? "6" : "5") << usual;
        EXPECT_EQ(chosen.settings.at(0).remarks.empty(), own) << usual;
    }
}

TEST_F(Printers, AProfileOfFilumIsAMachine) {
    const ChosenPrinter own = chosen_printer({"marlin", "", "tpu"});
    EXPECT_EQ(own.words, std::vector<std::string>{"--machine=marlin"});
    EXPECT_EQ(value_in(own, "temperature"), "230");
}

} // namespace
} // namespace filum::app::filum
