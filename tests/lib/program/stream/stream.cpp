// Property tests of the framing: what goes in comes out, and nothing broken passes.
#include "../../trials.hpp"
#include "base/error.hpp"
#include "stream/reader.hpp"
#include "stream/wireformat.hpp"
#include "stream/writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace filum::stream {
namespace {

std::string temporary(const std::string& name) {
    return testing::TempDir() + "filum-" + std::to_string(::getpid()) + "-" + name;
}

std::string bytes_of(const std::string& path) {
    std::ifstream f(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(f), {}};
}

void put(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

Header header() {
    Header h;
    h.payload = Payload::layers;
    h.expected = 3;
    h.history = {{"slice", "0.1.0", {{"layer-height", "0.2", false}}, {}}, {"x", "1", {{"a", "b", true}}, {0}}};
    return h;
}

std::string write(const std::string& path, const std::vector<RawFrame>& frames) {
    Writer writer(path, header());
    for (const auto& f : frames) writer.write(f);
    writer.close();
    return bytes_of(path);
}

// Reads all; the exit code that a command would end with, 0 if the stream is whole.
int verdict(const std::string& path, std::vector<RawFrame>* frames = nullptr) {
    try {
        Reader reader(path, Payload::unknown);
        while (auto f = reader.next())
            if (frames != nullptr) frames->push_back(std::move(*f));
        return 0;
    } catch (const Error& e) {
        return static_cast<int>(e.exit());
    }
}

std::vector<RawFrame> random_frames(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<RawFrame> frames(random() % 12);
    const std::size_t sizes[] = {0, 1, 127, 128, 1000, 300'000, 1'000'000};
    for (auto& f : frames) {
        f.tag = random() % 4 == 0 ? Tag::note : Tag::layer;
        f.body.resize(sizes[random() % 7]);
        for (auto& c : f.body) c = static_cast<char>(random());
    }
    return frames;
}

TEST(Stream, RandomFramesComeOutAsTheyWentIn) {
    const std::string path = temporary("round");
    for (unsigned seed = 0, n = trials(30); seed < n; ++seed) {
        const auto frames = random_frames(seed);
        write(path, frames);
        std::vector<RawFrame> got;
        ASSERT_EQ(verdict(path, &got), 0) << seed;
        ASSERT_EQ(got.size(), frames.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            EXPECT_EQ(got[i].tag, frames[i].tag);
            EXPECT_EQ(got[i].body, frames[i].body);
        }
    }
}

TEST(Stream, TheHeaderComesOutAsItWentIn) {
    const std::string path = temporary("header");
    write(path, {});
    const Reader reader(path, Payload::layers);
    const Header& h = reader.header();
    EXPECT_EQ(h.payload, Payload::layers);
    EXPECT_EQ(h.expected, 3U);
    ASSERT_EQ(h.history.size(), 2U);
    EXPECT_EQ(h.history[0].settings[0].value, "0.2");
    EXPECT_FALSE(h.history[0].settings[0].changed);
    EXPECT_TRUE(h.history[1].settings[0].changed);
    EXPECT_EQ(h.history[1].parents, std::vector<std::uint32_t>{0});
}

TEST(Stream, CutAtAnyByteItIsTruncated) {
    const std::string path = temporary("cut");
    const std::string whole = write(path, {{Tag::layer, std::string(40, 'a')}, {Tag::note, "n"}, {Tag::layer, ""}});
    for (std::size_t n = 0; n < whole.size(); ++n) {
        put(path, whole.substr(0, n));
        EXPECT_EQ(verdict(path), 4) << "cut at " << n << " of " << whole.size();
    }
}

TEST(Stream, AnyFlippedBitIsNoticed) {
    const std::string path = temporary("bit");
    const std::string whole = write(path, {{Tag::layer, std::string(40, 'a')}, {Tag::note, "n"}, {Tag::layer, ""}});
    for (std::size_t n = 0; n < whole.size(); ++n) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string broken = whole;
            broken[n] = static_cast<char>(broken[n] ^ (1 << bit));
            put(path, broken);
            const int code = verdict(path);
            EXPECT_TRUE(code == 3 || code == 4) << "byte " << n << " bit " << bit << ": " << code;
        }
    }
}

TEST(Stream, FramesLostSwappedOrRepeatedAreNoticed) {
    const std::string path = temporary("lost");
    const RawFrame a{Tag::layer, "first"}, b{Tag::layer, "other"};
    const std::string whole = write(path, {a, b});
    const std::string fa = frame_prefix(a.tag, a.body.size()) + a.body,
                      fb = frame_prefix(b.tag, b.body.size()) + b.body;
    const auto at = whole.find(fa);
    ASSERT_NE(at, std::string::npos);
    const std::string head = whole.substr(0, at), tail = whole.substr(at + fa.size() + fb.size());
    for (const auto& middle : {fa, fb, fb + fa, fa + fb + fb, fa + fa, std::string()}) {
        put(path, head + middle + tail);
        EXPECT_EQ(verdict(path), 3);
    }
    put(path, head + fa + fb + tail);
    EXPECT_EQ(verdict(path), 0);
}

TEST(Stream, FalseLengthsCostNoMemory) {
    const std::string path = temporary("long");
    const auto with = [&](std::uint64_t length, std::uint64_t inner) {
        std::string s = preamble();
        append_varint(s, length);
        append_varint(s, 1 << 3 | 2);
        append_varint(s, inner);
        put(path, s + "few bytes");
        return verdict(path);
    };
    rusage before{}, after{};
    ::getrusage(RUSAGE_SELF, &before);
    EXPECT_EQ(with(kMaxFrame, kMaxFrame - 5), 4);     // it might be true: read on, and find the end
    EXPECT_EQ(with(kMaxFrame + 1, kMaxFrame - 4), 3); // too long
    EXPECT_EQ(with(3, ~std::uint64_t{0} - 7), 3);     // the sum wraps around
    EXPECT_EQ(with(~std::uint64_t{0}, 1), 3);
    ::getrusage(RUSAGE_SELF, &after);
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 20'000); // kB
}

TEST(Stream, TagsThatOnlyLookRightAfterTruncationAreRefused) {
    const std::string path = temporary("tag");
    std::string inner;
    append_varint(inner, (std::uint64_t{1} << 32 | 1) << 3 | 2);
    append_varint(inner, 0);
    std::string s = preamble();
    append_varint(s, inner.size());
    put(path, s + inner);
    EXPECT_EQ(verdict(path), 3);
}

TEST(Stream, AnotherPayloadIsRefusedByName) {
    const std::string path = temporary("payload");
    write(path, {});
    try {
        const Reader reader(path, Payload::paths);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.exit(), Exit::bad_input);
        EXPECT_NE(std::string(e.what()).find("Layers, not Paths"), std::string::npos) << e.what();
    }
}

TEST(Stream, AFrameOfAnotherKindIsRefused) {
    const std::string path = temporary("kind");
    write(path, {{Tag::span, "x"}});
    EXPECT_EQ(verdict(path), 3);
}

TEST(Stream, HistoryThatRefersForwardIsRefused) {
    Header h = header();
    h.history[0].parents = {0};
    EXPECT_THROW(parse_header(serialise(h)), Error);
}

// Readers that do not know the code add notes up by themselves, so a frame has the grade of its code, not of its own
// amount.
TEST(Stream, ANoteOfLessThanADotHasTheGradeOfItsCode) {
    for (const double amount : {1e-9, 0.06, 0.13, 1.0}) {
        const Note n{.code = NoteCode::sliver_dropped, .amount = amount, .bead = 0.4};
        std::string frame = serialise(n);
        const std::string known = code_name(n), unknown = "sliver-of-2027";
        ASSERT_EQ(known.size(), unknown.size());
        frame.replace(frame.find(known), known.size(), unknown);
        const Note foreign = parse_note(frame);
        EXPECT_EQ(code_grade(foreign), Grade::look);
        EXPECT_EQ(grade(foreign), grade(n));
        EXPECT_EQ(grade(summed(Notes(1000, foreign))[0]), grade(summed(Notes(1000, n))[0]));
    }
    for (const double bead : {-1.0, HUGE_VAL, std::nan("")})
        EXPECT_EQ(parse_note(serialise({.code = NoteCode::sliver_dropped, .bead = bead})).bead, 0);
}

TEST(Stream, NotesComeOutAsTheyWentIn) {
    const Note note{.code = NoteCode::contour_gap_closed,
                    .amount = 0.25,
                    .count = 3,
                    .layer = 7,
                    .x = 1.5,
                    .detail = "d",
                    .patch = "A",
                    .stage = "slice",
                    .bead = 0.4};
    const Note got = parse_note(serialise(note));
    EXPECT_EQ(got.stage, note.stage);
    EXPECT_EQ(got.code, note.code);
    EXPECT_EQ(got.detail, "d");
    EXPECT_EQ(got.patch, "A");
    EXPECT_EQ(got.bead, 0.4);
    EXPECT_EQ(got.amount, note.amount);
    EXPECT_EQ(got.count, note.count);
    EXPECT_EQ(got.layer, note.layer);
    EXPECT_EQ(got.x, note.x);
    EXPECT_TRUE(std::isnan(got.y));
    EXPECT_TRUE(std::isnan(got.z));
    Note in_space = note;
    in_space.y = 2;
    in_space.z = 0;
    EXPECT_EQ(parse_note(serialise(in_space)).z, 0);
}

// A program of another make may know no codes and grades, or have its own.
TEST(Stream, ForeignNotesKeepTheirTextAndAreLookedAt) {
    Note note{.amount = 2, .stage = "mine"};
    note.foreign.text = "corner rounded";
    note.foreign.unit = "mm";
    const Note got = parse_note(serialise(note));
    EXPECT_EQ(got.code, NoteCode::foreign);
    EXPECT_EQ(sentence(got), "corner rounded: 1 case, 2 mm");
    EXPECT_EQ(code_name(got), "corner-rounded");
    EXPECT_EQ(grade(got), Grade::look);
    note.foreign.code = "own-code";
    note.foreign.grade = Grade::will_fail;
    EXPECT_EQ(code_name(parse_note(serialise(note))), "own-code");
    EXPECT_EQ(grade(parse_note(serialise(note))), Grade::will_fail);
}

// Streams that were written before notes had a z.
TEST(Stream, ANoteWithoutZHasNone) {
    const std::string old("\x0a\x01s\x12\x01w\x19\0\0\0\0\0\0\xf0\x3f\x28\x01\x39\0\0\0\0\0\0\xf0\x3f", 26);
    const Note got = parse_note(old);
    EXPECT_EQ(got.stage, "s");
    EXPECT_EQ(got.amount, 1);
    EXPECT_EQ(got.x, 1);
    EXPECT_TRUE(std::isnan(got.z));
}

TEST(Sink, ANamedFileAppearsOnlyByCommit) {
    const std::string path = temporary("sink");
    {
        Sink sink(path, Sink::Content::text);
        sink.write(std::string(1'000'000, 'x'));
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    Sink sink(path, Sink::Content::text);
    sink.write("whole");
    EXPECT_FALSE(std::filesystem::exists(path));
    sink.commit();
    EXPECT_EQ(bytes_of(path), "whole");
}

TEST(Sink, ALinkIsWrittenThrough) {
    const std::string path = temporary("real"), link = temporary("link");
    put(path, "old");
    std::filesystem::remove(link);
    std::filesystem::create_symlink(path, link);
    Sink sink(link, Sink::Content::text);
    sink.write("new");
    sink.commit();
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(bytes_of(path), "new");
}

void write(const std::string& path, const std::string& text) {
    Sink sink(path, Sink::Content::text);
    sink.write(text);
    sink.commit();
}

TEST(Sink, ALinkToNothingYetIsFollowed) {
    const std::string path = temporary("later"), link = temporary("dangling"), second = temporary("dangling2");
    for (const auto& name : {path, link, second}) std::filesystem::remove(name);
    std::filesystem::create_symlink(std::filesystem::path(path).filename(), link); // relative to its own folder
    std::filesystem::create_symlink(link, second);
    write(second, "new");
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_TRUE(std::filesystem::is_symlink(second));
    EXPECT_EQ(bytes_of(path), "new");
}

TEST(Sink, LinksInACircleAreAnError) {
    const std::string link = temporary("circle");
    std::filesystem::remove(link);
    std::filesystem::create_symlink(link, link);
    EXPECT_THROW(write(link, "x"), Error);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
}

TEST(Sink, AFileThatIsReplacedKeepsWhoMayReadIt) {
    const std::string path = temporary("secret");
    for (const int mode : {0600, 0640, 0644, 0755}) {
        put(path, "old");
        ASSERT_EQ(::chmod(path.c_str(), mode), 0);
        write(path, "new");
        struct stat info {};
        ASSERT_EQ(::stat(path.c_str(), &info), 0);
        EXPECT_EQ(info.st_mode & 0777, static_cast<mode_t>(mode));
        EXPECT_EQ(bytes_of(path), "new");
    }
    std::filesystem::remove(path);
    const mode_t before = ::umask(027);
    write(path, "new");
    ::umask(before);
    struct stat info {};
    ASSERT_EQ(::stat(path.c_str(), &info), 0);
    EXPECT_EQ(info.st_mode & 0777, static_cast<mode_t>(0640));
}

TEST(Sink, WhatIsOpenAlreadyIsWrittenToAndNotReplaced) {
    const std::string path = temporary("open");
    put(path, "first ");
    const int fd = ::open(path.c_str(), O_WRONLY | O_APPEND);
    ASSERT_GE(fd, 0);
    write("/dev/fd/" + std::to_string(fd), "second ");
    write("/proc/self/fd/" + std::to_string(fd), "third");
    ::close(fd);
    EXPECT_EQ(bytes_of(path), "first second third");
    EXPECT_THROW(write("/dev/fd/" + std::to_string(fd), "x"), Error);
}

} // namespace
} // namespace filum::stream
