// Profiles: every shipped one loads, every mistake is found and named.
#include "machine/profile.hpp"

#include "base/error.hpp"
#include "machine/template.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace filum;
using machine::Feeding;

namespace {

const std::string kLeast = "name = \"m\"\n[bed]\nx = [0, 220]\ny = [0, 220]\nz = [0, 250]\n"
                           "[extrusion]\nkind = \"filament\"\ndiameter = 1.75\n";

std::string error_of(const std::string& text, Exit exit = Exit::bad_input, const std::string& set = "") {
    try {
        (void)machine::parse_profile(text, "m.toml", set);
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), exit) << e.what();
        return e.what();
    }
    return "";
}

} // namespace

TEST(Profile, EveryShippedOneLoads) {
    const auto names = machine::profile_names();
    for (const char* wanted :
         {"bio-x", "cellink-inkredible", "klipper", "linuxcnc", "marlin", "reprapfirmware", "syringe"})
        EXPECT_EQ(std::count(names.begin(), names.end(), wanted), 1) << wanted;
    for (const auto& name : names) {
        const auto p = machine::load_profile(name);
        EXPECT_EQ(p.name, name);
        EXPECT_EQ(p.fingerprint.size(), 16u);
        EXPECT_FALSE(p.about.empty());
        EXPECT_FALSE(p.templates.start.empty());
    }
}

TEST(Profile, ABaseGivesWhatTheProfileLacks) {
    const machine::ProfileText own{"name = \"mine\"\nbase = \"m\"\n[bed]\ny = [0, 300]\n[feeds]\nbead = 33\n",
                                   "mine.toml"};
    const machine::ProfileText middle{"name = \"m\"\nbase = \"b\"\n[feeds]\nbead = 44\ntravel = 99\n", "m.toml"};
    const machine::ProfileText base{kLeast + "[values]\nheat = 1\n[templates]\nstart = \"M1 {heat}\"\n", "b.toml"};
    const std::vector all{own, middle, base};
    const auto p = machine::parse_profile(all, "feeds.lift=11");
    EXPECT_EQ(p.name, "mine");
    EXPECT_EQ(p.bed.y_max, 300);
    EXPECT_EQ(p.bed.x_max, 220);
    EXPECT_EQ(p.feeds.bead, 33);
    EXPECT_EQ(p.feeds.travel, 99);
    EXPECT_EQ(p.feeds.lift, 11);
    EXPECT_EQ(p.templates.start, "M1 {heat}");
    EXPECT_NE(p.fingerprint, machine::parse_profile(std::vector{own, base}, "").fingerprint);
    try { // a fault of the base is placed in its file
        const machine::ProfileText wrong{"name = \"b\"\n\n[feeds]\njog = \"x\"\n", "wrong.toml"};
        (void)machine::parse_profile(std::vector{own, wrong, base}, "");
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find("'wrong.toml', line 4, key 'feeds.jog'"), std::string::npos) << e.what();
    }
    EXPECT_NE(error_of(own.text).find("base"), std::string::npos);
}

TEST(Profile, MarlinShowsTheDefaults) {
    const auto shown = machine::load_profile("marlin");
    const auto least = machine::parse_profile(kLeast, "m.toml");
    EXPECT_EQ(shown.head.flat_radius, least.head.flat_radius);
    EXPECT_NEAR(shown.head.cone_angle, least.head.cone_angle, 1e-12);
    EXPECT_EQ(shown.head.cone_height, least.head.cone_height);
    EXPECT_EQ(shown.head.carriage_x, least.head.carriage_x);
    EXPECT_EQ(shown.head.gantry_height, least.head.gantry_height);
    EXPECT_EQ(shown.extrusion.letter, least.extrusion.letter);
    EXPECT_EQ(shown.extrusion.relative, least.extrusion.relative);
    const auto feeds = [](const machine::Profile& p) {
        const auto& f = p.feeds;
        const auto& m = p.motion;
        const auto& t = p.travel;
        return std::vector<double>{
            f.bead, f.first_layer, f.lift,          f.jog,          f.connector,    f.travel,
            f.z,    m.max_speed,   m.max_speed_z,   m.acceleration, m.corner_speed, m.travel_acceleration,
            t.lift, t.retract,     t.retract_speed, t.extra,        t.min_length,   p.extrusion.flow};
    };
    EXPECT_EQ(feeds(shown), feeds(least));
    EXPECT_EQ(shown.format.xyz_decimals, least.format.xyz_decimals);
    EXPECT_EQ(shown.format.e_decimals, least.format.e_decimals);
    EXPECT_EQ(shown.format.f_decimals, least.format.f_decimals);
    EXPECT_EQ(shown.format.viewer_comments, least.format.viewer_comments);
    EXPECT_EQ(shown.format.travel_code, least.format.travel_code);
}

TEST(Profile, MaterialIsCountedByKind) {
    const auto of = [](const std::string& name) { return machine::load_profile(name).extrusion; };
    EXPECT_EQ(of("marlin").feeding, Feeding::filament);
    EXPECT_NEAR(of("marlin").per_mm3(), 4 / (std::numbers::pi * 1.75 * 1.75), 1e-12);
    EXPECT_EQ(of("syringe").feeding, Feeding::plunger);
    EXPECT_NEAR(of("syringe").per_mm3(), 4 / (std::numbers::pi * 14.5 * 14.5), 1e-12);
    EXPECT_EQ(of("bio-x").feeding, Feeding::volume);
    EXPECT_EQ(of("bio-x").per_mm3(), 1);
    EXPECT_EQ(of("cellink-inkredible").feeding, Feeding::valve);
    EXPECT_EQ(machine::load_profile("bio-x").bed.centre(), (geom::Vec2{0, 0}));
}

TEST(Profile, MistakesAreNamedWithFileLineAndKey) {
    struct Case {
        std::string text, says;
    };
    const std::string head = "cannot use profile 'm.toml', line ";
    const Case cases[] = {
        {kLeast + "[feeds]\nbaed = 50\n", head + "10, key 'feeds.baed': there is no such key"},
        {kLeast + "[fedes]\nbead = 50\n", head + "9, key 'fedes': there is no such key"},
        {kLeast + "[feeds]\n\nbead = \"fast\"\n", head + "11, key 'feeds.bead': it must be a number"},
        {kLeast + "[feeds]\nbead = nan\n", head + "10, key 'feeds.bead': it must be at least 0.01"},
        {kLeast + "[feeds]\nbead = 400\n", "key 'feeds.bead': it must not be above motion.max_speed, 300"},
        {kLeast + "[motion]\nmax_speed = 40\n", "key 'feeds.bead': it must not be above motion.max_speed, 40"},
        {kLeast + "[motion]\nacceleration = 0\n", "key 'motion.acceleration': it must be above 0"},
        {kLeast + "[format]\nxyz_decimals = 2.5\n", "key 'format.xyz_decimals': it must be a whole number from 2 to 6"},
        {kLeast + "[format]\nxyz_decimals = 99\n", "it must be a whole number from 2 to 6"},
        {kLeast + "[format]\nviewer_comments = 1\n", "it must be true or false"},
        {kLeast + "[format]\ncomments = \"c\"\n", "it must be one of semicolon, parentheses"},
        {kLeast + "mode = \"relative\"\nletter = \"A\"\n",
         "key 'extrusion.mode': an axis other than E counts absolutely"},
        {kLeast + "letter = 5\n", "key 'extrusion.letter': it must be a text in quotes"},
        {kLeast + "on = \"\\u0001\"\n", "it holds a control character"},
        {kLeast + "[templates]\nstart = \"\"\"\nG28\nM104 S{temp}\n\"\"\"\n",
         head + "12, key 'templates.start': unknown placeholder '{temp}'"},
        {kLeast + "[templates]\nend = \"M104 S{\"\n", "'{' has no '}' behind it"},
        {kLeast + "[values]\nlayer = 4\n", "key 'values.layer': the name is taken"},
        {kLeast + "[values]\ntemp = \"hot\"\n", "key 'values.temp': it must be a number"},
        {kLeast + "[head]\ncarriage = [40]\n", "key 'head.carriage': it must be two numbers in brackets"},
        {"name = \"m\"\n[bed]\nx = [5, 5]\ny = [0, 1]\nz = [0, 1]\n",
         head + "3, key 'bed.x': the first number must be below"},
        {"name = \"m\"\n", "key 'bed.x': it is missing"},
        {"bed = 3\nname = \"m\"\n", "key 'bed.x': it is missing"},
        {"name = \"../m\"\n" + kLeast.substr(11), "key 'name': it must be letters"},
        {"name = \"m\"\nname = \"n\"\n", "cannot read profile 'm.toml', line 2"},
        {"name = \n", "cannot read profile 'm.toml', line 1"},
        {"\n[=]\n", "cannot read profile 'm.toml', line 2: "},
        {"x = [1,}\n", "cannot read profile 'm.toml'"},
        {"[ #]\n", "cannot read profile 'm.toml', line 1: "},
        {kLeast + "\xc3\xa4 = 3\n", "cannot read profile 'm.toml', line 9: "},
        {kLeast + "[[\t+]]\n", "cannot read profile 'm.toml'"},
        {"\xff\xfe", "cannot read profile 'm.toml', line 1: a byte that is not UTF-8"},
        {kLeast + "a = '\xa2\xa2'\n", "cannot read profile 'm.toml', line 9: a byte that is not UTF-8"},
        {"", "key 'name': it is missing"},
        {kLeast + "[feedz]\nbead = 10\n[motion]\nmax_speed = 20\n",
         "key 'feeds.bead': it must not be above motion.max_speed, 20; is 'feedz' meant to be 'feeds'?"},
        {"nam = \"m\"\n", "key 'name': it is missing; is 'nam' meant to be 'name'?"},
        {"name = \"m\"\n[bde]\nx = [0, 9]\n", "key 'bed.x': it is missing; is 'bde' meant to be 'bed'?"},
    };
    EXPECT_EQ(error_of(kLeast), "");
    EXPECT_EQ(error_of("\xef\xbb\xbf" + kLeast + "# 60 \xc2\xb0 \n[templates]\nend = '; \xc2\xb5m'\n"), "");
    for (const auto& c : cases) {
        const auto what = error_of(c.text);
        EXPECT_NE(what.find(c.says), std::string::npos) << c.text << "\nsays: " << what;
    }
}

// Texts with bytes changed, taken out and put in: a profile, or an error, never a crash of the parser.
TEST(Profile, DamagedTextsAreProfilesOrErrors) {
    std::mt19937 random(1);
    const std::string marks = "[]{}=\"'\\#.,\n\r\t-+_e0x\x80\xff";
    for (int round = 0; round < 4000; ++round) {
        std::string text = kLeast + "[templates]\nstart = \"\"\"\nM104 S{nozzle}\n\"\"\"\n[values]\nnozzle = 200\n";
        for (std::size_t k = 1 + random() % 4; k > 0; --k) {
            const std::size_t at = random() % text.size();
            const char mark = marks[random() % marks.size()];
            if (random() % 3 == 0)
                text.erase(at, 1 + random() % 3);
            else if (random() % 2 == 0)
                text[at] = mark;
            else
                text.insert(at, 1 + random() % 3, mark);
        }
        const std::string what = error_of(text);
        EXPECT_TRUE(what.empty() || what.find("m.toml") != std::string::npos || what.find("key") != std::string::npos)
            << text << what;
    }
    for (const char* nested : {"[", "{a=", "[[", "a."}) {
        std::string text = "x = ";
        for (int k = 0; k < 100'000; ++k) text += nested;
        EXPECT_NE(error_of(text), "");
    }
}

TEST(Profile, EveryPrefixOfAProfileIsAProfileOrAnError) {
    const std::string whole = kLeast + "[templates]\nstart = \"\"\"\nM104 S{nozzle}\n\"\"\"\n[values]\nnozzle = 200\n";
    for (std::size_t n = 0; n <= whole.size(); ++n) (void)error_of(whole.substr(0, n));
    for (std::size_t n = 0; n < whole.size(); ++n) {
        std::string flipped = whole;
        flipped[n] = static_cast<char>(flipped[n] ^ 0x11);
        (void)error_of(flipped);
    }
}

TEST(Profile, KeysCanBeSet) {
    const std::string templates = "[templates]\nstart = \"M104 S{temp}\"\nend = \"M106 S{fan}\"\n";
    const std::string text = kLeast + "[values]\ntemp = 200\nfan = 1\n" + templates;
    const auto p =
        machine::parse_profile(text, "m.toml", "feeds.bead=41.5,temp=230,fan=9,extrusion.mode=absolute,head.none=true");
    EXPECT_EQ(p.feeds.bead, 41.5);
    EXPECT_EQ(p.values.at("temp"), 230);
    EXPECT_EQ(p.values.at("fan"), 9);
    EXPECT_FALSE(p.extrusion.relative);
    EXPECT_TRUE(p.head.none);
    EXPECT_EQ(p.fingerprint, machine::parse_profile(text, "m.toml").fingerprint);
    EXPECT_NE(error_of(kLeast, Exit::usage, "feeds.baed=4").find("cannot set 'feeds.baed': there is no such key"),
              std::string::npos);
    EXPECT_NE(error_of(kLeast, Exit::usage, "feeds.bead=fast").find("it must be a number"), std::string::npos);
    EXPECT_NE(error_of(kLeast, Exit::usage, "feeds.bead=400").find("above motion.max_speed"), std::string::npos);
    for (const char* wrong : {"feeds", "=3", ".x=3", "a.=3", "a.b.c=3", "name.x=3", ",", "feeds.bead=1e999"})
        EXPECT_NE(error_of(kLeast, Exit::usage, wrong), "") << wrong;
}

TEST(Profile, ValuesThatNoTemplateNamesAreErrors) {
    const std::string text = kLeast + "[values]\nnozzle_temp = 200\n[templates]\nstart = \"M104 S{nozzle_temp}\"\n";
    EXPECT_EQ(machine::parse_profile(text, "m.toml").values.size(), 1U);
    EXPECT_NE(error_of(text, Exit::usage, "nozle_temp=230").find("did you mean 'nozzle_temp'?"), std::string::npos);
    EXPECT_NE(error_of(text, Exit::usage, "bead=40").find("did you mean 'feeds.bead'?"), std::string::npos);
    EXPECT_NE(error_of(text, Exit::usage, "feeds.baed=40").find("did you mean 'feeds.bead'?"), std::string::npos);
    const std::string idle = kLeast + "[values]\nfan = 200\n";
    EXPECT_NE(error_of(idle, Exit::bad_input).find("key 'values.fan': no template names it"), std::string::npos);
    EXPECT_NE(error_of(kLeast + "[tempaltes]\nstart = \"x\"\n", Exit::bad_input).find("no such key"),
              std::string::npos);
}

TEST(Profile, AnUnknownNameListsTheKnown) {
    try {
        (void)machine::load_profile("nosuch");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::usage);
        std::string known;
        for (const std::string& name : machine::profile_names()) known += (known.empty() ? "" : ", ") + name;
        EXPECT_NE(std::string(e.what()).find("known are " + known), std::string::npos) << e.what();
    }
    EXPECT_THROW((void)machine::load_profile(""), Error);
    EXPECT_THROW((void)machine::load_profile("./nosuch.toml"), Error);
}

TEST(Profile, AStartThatPurgesLeavesMaterialAtTheTip) {
    EXPECT_TRUE(machine::load_profile("marlin").templates.primed);
    EXPECT_FALSE(machine::load_profile("marlin", "templates.start=G28").templates.primed);
    EXPECT_FALSE(machine::load_profile("syringe").templates.primed);
}

TEST(Template, BracesAndNames) {
    const machine::Values v{{"a", 1.5}, {"b", -1e-9}, {"c", 1e15}};
    EXPECT_EQ(machine::expand("x{a}{a} {{a}} {b} {c}", v), "x1.51.5 {a} 0 1000000000000000");
    EXPECT_EQ(machine::expand("{if a > 1}G1 X{min(a * 2, 2)}{else}G28{endif} [x]", v), "G1 X2 [x]");
    EXPECT_EQ(machine::words_in_braces("x {a + b_2} c {{d}}"), (std::set<std::string>{"a", "b_2", "d"}));
    EXPECT_THROW((void)machine::expand("{d}", v), Error);
    EXPECT_EQ(machine::check_template("G1 Z{z_park}\nX{nope}", {}).line, 1u);
    for (const char* wrong : {"{", "}", "a{b", "{a\n", "{{a}", "{}"})
        EXPECT_NE(machine::check_template(wrong, v).why, "");
}
