#include "app/filum/front.hpp"

#include "../files.hpp"
#include "app/filum/stage.hpp"

namespace filum::app::filum {
namespace {

using namespace test;

TEST(Front, RefusesWhatIsNoCommand) {
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"nonsense"}, {""}, {"filum"}, {"../bin/sh"}, {"/bin/sh"}, {"help", "nonsense"}}) {
        const Refusal r = refusal([&] { front(words); });
        EXPECT_EQ(r.exit, 2) << words[0];
        EXPECT_TRUE(tells(r.what, "unknown command")) << r.what;
    }
    for (const char* alone : {"list", "env"}) EXPECT_EQ(refusal([&] { front({alone, "more"}); }).exit, 2) << alone;
}

TEST(Stage, AProgramThatTellsNothingIsNone) {
    // the stages are sought beside this program: any program there may be asked, but must answer
    const std::string name = "mute-" + std::to_string(::getpid()), file = stage_folder() + "/" + name;
    std::ofstream(file) << "#!/bin/sh\necho hello\n";
    EXPECT_EQ(refusal([&] { ask(name); }).exit, 2); // not executable
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    const Refusal r = refusal([&] { ask(name); });
    EXPECT_EQ(r.exit, 1);
    EXPECT_TRUE(tells(r.what, "says nothing about itself")) << r.what;
    std::ofstream(file)
        << "#!/bin/sh\necho 'synopsis does it'; echo 'in Layers'; echo 'out Regions'; echo 'flag fast'; "
           "echo 'option height MM'\n";
    const Stage stage = ask(name);
    std::filesystem::remove(file);
    EXPECT_EQ(stage.synopsis, "does it");
    EXPECT_EQ(stage.in, "Layers");
    EXPECT_EQ(stage.out, "Regions");
    ASSERT_EQ(stage.options.size(), 2U);
    EXPECT_FALSE(stage.options[0].takes_value);
    EXPECT_EQ(stage.options[1].name, "height");
    EXPECT_TRUE(stage.options[1].takes_value);
}

} // namespace
} // namespace filum::app::filum
