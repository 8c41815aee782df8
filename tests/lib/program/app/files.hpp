// Files of one test, and the streams in them.
#pragma once

#include "base/error.hpp"
#include "cli/output.hpp"
#include "stream/reader.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace filum::app::test {

// A folder of its own, gone with everything in it at the end.
class Folder {
  public:
    Folder() {
        static std::atomic<int> count = 0;
        path_ = std::filesystem::path(testing::TempDir()) /
                ("filum_app." + std::to_string(::getpid()) + "." + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { std::filesystem::remove_all(path_); }

    // The file of that name in it.
    [[nodiscard]] std::string operator()(const std::string& name) const { return (path_ / name).string(); }

    [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return (*this)(name);
    }
    [[nodiscard]] std::string text(const std::string& name) const {
        std::ifstream in(path_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }

  private:
    std::filesystem::path path_;
};

// What a program of that name is run with; it says nothing.
inline cli::Io io(const std::string& program, const std::string& input, const std::string& output) {
    cli::Io out;
    out.program = program;
    out.input = input;
    out.output = output;
    out.threads = 1;
    out.quiet = true;
    return out;
}

// A stream by the program "before".
inline std::string write_stream(const std::string& file, stream::Payload payload,
                                const std::vector<stream::RawFrame>& frames, const Notes& notes = {},
                                const Facts& facts = {}) {
    const cli::Io self = io("before", "-", file);
    cli::Output out(self, cli::header(self, payload));
    out.add(notes);
    out.add(facts);
    for (const auto& f : frames) out.write(f);
    out.close();
    return file;
}

struct Stream {
    cli::WholeInput told;
    std::vector<stream::RawFrame> frames;
};

inline Stream read_stream(const std::string& file, stream::Payload payload) {
    Stream out;
    out.told = cli::read_all(file, payload, [&](stream::RawFrame f) { out.frames.push_back(std::move(f)); });
    return out;
}

inline const Fact* find(const Facts& facts, const std::string& stage, const std::string& name) {
    const Fact* out = nullptr; // the latest holds
    for (const Fact& f : facts)
        if (f.stage == stage && f.name == name) out = &f;
    return out;
}

// The exit code and the message of the Error that `work` throws; 0 if it throws none.
struct Refusal {
    int exit = 0;
    std::string what;
};
template <class Work>
Refusal refusal(const Work& work) {
    try {
        work();
    } catch (const Error& e) {
        return {static_cast<int>(e.exit()), e.what()};
    }
    return {};
}

// That `what` holds `part`.
inline bool tells(const std::string& what, const std::string& part) { return what.find(part) != std::string::npos; }

} // namespace filum::app::test
