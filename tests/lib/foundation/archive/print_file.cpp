#include "archive/print_file.hpp"

#include "archive/zip.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::archive {
namespace {

// Random bytes, some of them many times over.
std::string random_bytes(std::mt19937& random, std::size_t size) {
    std::string out;
    while (out.size() < size) out.append(1 + random() % 20, static_cast<char>(random() % 256));
    out.resize(size);
    return out;
}

TEST(Zipped, ReadsBackAndIsTheSameEachTime) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<std::pair<std::string, std::string>> files;
        for (unsigned i = 0; i <= random() % 6; ++i)
            files.emplace_back("folder " + std::to_string(i) + "/\xc3\xa4.txt", random_bytes(random, random() % 40000));
        const std::string bytes = zipped(files);
        EXPECT_EQ(bytes, zipped(files));
        Zip zip(bytes, "it", Zip::Names::of_both_places);
        for (const auto& [path, content] : files) EXPECT_EQ(zip.read(path), content) << path;
    }
    const std::string empty = zipped({{"nothing", ""}});
    EXPECT_EQ(Zip(empty, "it").read("nothing"), "");
}

TEST(PrintFile, StatesTheSumOfItsProgram) {
    for (const auto& [program, sum] :
         {std::pair{"", "D41D8CD98F00B204E9800998ECF8427E"}, {"abc", "900150983CD24FB0D6963F7D28E17F72"}}) {
        PrintFile file;
        file.gcode = program;
        const std::string bytes = written(file);
        Zip zip(bytes, "it", Zip::Names::of_both_places);
        EXPECT_EQ(zip.read("Metadata/plate_1.gcode"), program);
        EXPECT_EQ(zip.read("Metadata/plate_1.gcode.md5"), sum);
        EXPECT_FALSE(zip.has("Metadata/plate_1.png"));
    }
}

TEST(PrintFile, NamesAPrinterOfBambuLabByItsModel) {
    for (const auto& [printer, id] : {std::pair{"Bambu Lab P1S", "C12"},
                                      {"bambu lab A1 mini 0.4 nozzle", "N1"},
                                      {"Bambu Lab A1", "N2S"},
                                      {"Bambu Lab X1 Carbon", "BL-P001"},
                                      {"Bambu Lab X1E", "C13"},
                                      {"A1 of mine", ""},
                                      {"marlin", ""}}) {
        PrintFile file;
        file.printer = printer;
        const std::string bytes = written(file);
        const std::string info = Zip(bytes, "it").read("Metadata/slice_info.config");
        const std::string key = R"("printer_model_id" value=")";
        if (*id == '\0')
            EXPECT_EQ(info.find(key), std::string::npos) << printer;
        else
            EXPECT_NE(info.find(key + id + '"'), std::string::npos) << printer << '\n' << info;
    }
}

TEST(PrintFile, KeepsNamesOfPartsOutOfItsMarkup) {
    const std::string name = "\"><evil/>&\\\n";
    PrintFile file;
    file.parts = {{name, {1, 2, 3, 5}}};
    file.filaments = {{0, 1.5, 4.25}};
    const std::string bytes = written(file);
    Zip zip(bytes, "it");
    EXPECT_EQ(zip.read("Metadata/slice_info.config").find("<evil"), std::string::npos);
    const std::string boxes = zip.read("Metadata/plate_1.json");
    EXPECT_NE(boxes.find(R"("bbox_all":[1,2,3,5])"), std::string::npos) << boxes;
    EXPECT_NE(boxes.find(R"("area":6,)"), std::string::npos) << boxes;
    EXPECT_NE(boxes.find(R"(\"><evil/>&\\\u000a)"), std::string::npos) << boxes;
}

} // namespace
} // namespace filum::archive
