#include "cli/output_name.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

namespace filum::cli {
namespace {

bool allowed(const std::string& name, const std::string& what) {
    try {
        check_output_name(name, "it", what);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::usage);
        return false;
    }
    return true;
}

} // namespace

TEST(OutputName, EndingsMeanWhatTheySay) {
    const std::string code = "machine code", picture = "a PNG picture, SVG, PDF, VTP or an HTML page",
                      stream = "a stream of Layers";
    for (const char* name : {"x.gcode", "x.GCODE", "a.b/x.nc", "x.ngc", "x.src", "x.mod", "x.script", "x", "-",
                             "a.pdf/x", "x.bgcode", "x.gcode.3mf", "x.txt", "/dev/null", ".gcode", "x.2"})
        EXPECT_TRUE(allowed(name, code)) << name;
    for (const char* name : {"x.pdf", "x.jpg", "x.3mf", "x.png", "x.PDF", "x.gx", "x.html", "x.stl", "x.zip",
                             "x.toolpath", "x.regions", "x.Layers", "x.paths", "x.surface"})
        EXPECT_FALSE(allowed(name, code)) << name;
    for (const char* name : {"x.png", "x.svg", "x.pdf", "x.vtp", "x.html", "x"})
        EXPECT_TRUE(allowed(name, picture)) << name;
    for (const char* name : {"x.jpg", "x.ps", "x.gcode", "x.webp"}) EXPECT_FALSE(allowed(name, picture)) << name;
    for (const char* name : {"x.jpg", "x.toolpath"}) EXPECT_FALSE(allowed(name, picture)) << name;
    for (const char* name : {"x.layers", "x.toolpath", "x", "x.json", "x.txt", "x.patches"})
        EXPECT_TRUE(allowed(name, stream)) << name;
    for (const char* name : {"x.gcode", "x.bgcode", "x.pdf", "x.png", "x.stl", "x.html"})
        EXPECT_FALSE(allowed(name, stream)) << name;
}

} // namespace filum::cli
