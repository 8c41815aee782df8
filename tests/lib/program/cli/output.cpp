#include "cli/output.hpp"

#include "cli/agree.hpp"
#include "stream/reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace filum::cli {
namespace {

using stream::Payload;
using stream::Tag;

// A file of this test alone, gone at its end.
struct File {
    std::string path = testing::TempDir() + "output_test." + std::to_string(::getpid());
    File() = default;
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { std::filesystem::remove(path); }
};

Io stage(const File& file) {
    Io io;
    io.program = "stage";
    io.output = file.path;
    io.settings = {{"width", "0.4", false}};
    return io;
}

// Every frame as a word or two.
std::vector<std::string> frames(const std::string& path) {
    std::vector<std::string> out;
    stream::Reader reader(path, Payload::unknown);
    while (const auto f = reader.next()) {
        if (f->tag == Tag::note) {
            const Note n = stream::parse_note(f->body);
            out.push_back(n.stage + " noted " + code_name(n));
        } else if (f->tag == Tag::fact) {
            const Fact x = stream::parse_fact(f->body);
            out.push_back(x.stage + " found " + x.name + " " + x.unit);
        } else {
            out.push_back("payload of " + std::to_string(f->body.size()) + " bytes");
        }
    }
    return out;
}

TEST(Output, KeepsTheOrderAndNamesWhatIsItsOwn) {
    const File file;
    const Io io = stage(file);
    WholeInput before{header(io, Payload::layers),
                      {{.code = NoteCode::sliver_dropped, .amount = 1, .stage = "other"}},
                      {{"other", "area", 2, "mm2"}}};
    before.facts.push_back({"stage", "area", 3, "mm2"});
    testing::internal::CaptureStderr();
    Output output(io, header(io, Payload::regions, {&before.header}));
    output.pass_on(before, [](const Fact& f) { return f.stage != "stage"; });
    output.add(Notes{{NoteCode::contour_opening_closed, 1},
                     {.code = NoteCode::contour_opening_closed, .amount = 2, .stage = "misnamed"}});
    output.write({Tag::region, "abc"});
    output.add(Note{NoteCode::cad_face_unread, 0, 2});
    output.add(Note{NoteCode::hairline_gap_closed, 0, 2});
    output.add(Facts{{"", "strokes", 4, "strokes"}});
    EXPECT_FALSE(std::filesystem::exists(file.path)); // nothing counts until it is closed
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    testing::internal::CaptureStderr();
    output.close();
    EXPECT_EQ(
        testing::internal::GetCapturedStderr(),
        "stage: look: 2 wide openings of contours were closed by a straight line, 3 mm in all; compare the layers "
        "with the part, or repair the mesh [contour-opening-closed]\n"
        "stage: look: 2 CAD faces that OpenCASCADE could not read were dropped; export the part again, or as STL "
        "[cad-face-unread]\n");
    const std::vector<std::string> expected{
        "other noted sliver-dropped",         "other found area mm2",       "stage noted contour-opening-closed",
        "stage noted contour-opening-closed", "payload of 3 bytes",         "stage noted cad-face-unread",
        "stage noted hairline-gap-closed",    "stage found strokes strokes"};
    EXPECT_EQ(frames(file.path), expected);
    const auto history = stream::Reader(file.path, Payload::regions).header().history;
    ASSERT_EQ(history.size(), 2U);
    EXPECT_EQ(history[1].parents, std::vector<std::uint32_t>{0});
}

TEST(Output, PassesAllOnWhereNothingIsAsked) {
    const File file;
    const Io io = stage(file);
    Output output(io, header(io, Payload::layers));
    output.pass_on(
        {{}, {{.code = NoteCode::sliver_dropped, .amount = 1, .stage = "stage"}}, {{"stage", "area", 3, "mm2"}}});
    testing::internal::CaptureStderr();
    output.close(); // notes of earlier stages are not printed again
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(frames(file.path), (std::vector<std::string>{"stage noted sliver-dropped", "stage found area mm2"}));
}

TEST(Output, LeavesNoFileIfItIsNotClosed) {
    const File file;
    {
        const Io io = stage(file);
        Output output(io, header(io, Payload::layers));
        output.write({Tag::layer, "abc"});
    }
    EXPECT_FALSE(std::filesystem::exists(file.path));
}

TEST(Output, IsQuietIfAsked) {
    const File file;
    Io io = stage(file);
    io.quiet = true;
    testing::internal::CaptureStderr();
    Output output(io, header(io, Payload::layers));
    output.add(Note{NoteCode::cad_face_unread, 0, 2});
    output.close();
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(frames(file.path), std::vector<std::string>{"stage noted cad-face-unread"});
}

stream::Header after(const std::string& before, const std::string& own, bool changed = true) {
    stream::Header h;
    h.history.push_back({"regions", "1", {{"width", before, changed}}, {}});
    h.history.push_back({"sequence", "1", {}, {0}});
    h.history.push_back({"fill", "1", {{"width", own, changed}}, {1}});
    return h;
}

TEST(Agree, AStageToldOtherwiseIsNoted) {
    Io io;
    io.program = "fill";
    io.same = {{"width", {"regions.width"}}};
    EXPECT_TRUE(disagreements(io, after("0.4", "0.4")).empty());
    io.same = {{"width", {"regions.width", "sequence.width"}}};
    const Notes notes = disagreements(io, after("0.4", "0.8"));
    ASSERT_EQ(notes.size(), 2U); // sequence has none at all, and here it is given
    EXPECT_EQ(notes[0].code, NoteCode::setting_differs);
    EXPECT_EQ(notes[0].detail, "--width is 0.8, but 'regions' had --width 0.4");
    EXPECT_EQ(disagreements(io, after("0.4", "0.8", false)).size(), 1U);
    io.same = {{"width", {"slice.width"}}};
    EXPECT_TRUE(disagreements(io, after("0.4", "0.8")).empty()); // slice did not run
}

TEST(Agree, StandsInTheStream) {
    const File file;
    Io io = stage(file);
    io.quiet = true;
    io.same = {{"width", {"regions.width"}}};
    stream::Header h = after("0.4", "0.8");
    h.history.back().program = "stage";
    h.payload = Payload::layers;
    Output output(io, h);
    output.close();
    stream::Reader reader(file.path, Payload::layers);
    const auto frame = reader.next();
    ASSERT_TRUE(frame && frame->tag == Tag::note);
    EXPECT_EQ(stream::parse_note(frame->body).code, NoteCode::setting_differs);
}

// The note that a program with these runs before it writes.
Note note_after(const std::vector<stream::Run>& runs) {
    const File file;
    const Io io = stage(file);
    const stream::Header before{Payload::layers, runs};
    testing::internal::CaptureStderr();
    Output output(io, header(io, Payload::regions, {&before}));
    output.add(Note{.code = NoteCode::sliver_dropped, .amount = 0.01});
    output.close();
    testing::internal::GetCapturedStderr();
    stream::Reader reader(file.path, Payload::regions);
    return stream::parse_note(reader.next()->body);
}

TEST(Output, GradesNotesByTheNarrowestBeadOfTheHistory) {
    const auto run = [](const std::string& program, const std::string& setting, const std::string& value) {
        return stream::Run{program, "1", {{setting, value, false}}, {}};
    };
    EXPECT_EQ(note_after({}).bead, 0);
    EXPECT_EQ(grade(note_after({})), Grade::look);
    EXPECT_EQ(grade(note_after({run("regions", "bead-width", "0.4")})), Grade::harmless);
    EXPECT_EQ(note_after({run("regions", "bead-width", "0.8"), run("fill", "bead-width", "0.4")}).bead, 0.4);
    EXPECT_EQ(note_after({run("regions", "bead-width", "0"), run("fill", "bead-width", "0.4")}).bead, 0.4);
    EXPECT_EQ(note_after({run("geodesic", "spacing", "1"), run("surfpath", "spacing", "3")}).bead, 0);
    EXPECT_EQ(note_after({run("regions", "bead-width", "wide")}).bead, 0);
    EXPECT_EQ(note_after({run("regions", "bead-width", "-1")}).bead, 0);
}

} // namespace
} // namespace filum::cli
