#include "app/filum/compare.hpp"

#include "app/filum/distribute.hpp"
#include "app/filum/process.hpp"
#include "app/filum/show.hpp"
#include "app/filum/stage.hpp"
#include "base/error.hpp"
#include "base/shell.hpp"
#include "stream/sink.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace filum::app::filum {

namespace {

constexpr std::array kAlgorithms{"fina", "fexa", "ortheo", "geo-fiso", "geo-contour", "geo-spiral", "field", "hybrid"};

// A column of the table: the key of the figure in `metrics`, and the heading.
struct Figure {
    const char *key, *heading;
};
constexpr Figure kFigures[] = {{"coverage", "coverage"}, {"cuts", "cuts"},         {"overlap", "overlap"},
                               {"tight_mm", "tight mm"}, {"kinks_mm", "kinks mm"}, {"fibre_mm", "length mm"}};

void write_file(const std::string& file, const std::string& text) {
    stream::Sink out(file, stream::Sink::Content::text);
    out.write(text);
    out.commit();
}

Command command_of(const Stage& stage, const std::vector<std::string>& arguments,
                   const std::vector<std::string>& more) {
    Command out{stage.program};
    out.insert(out.end(), arguments.begin(), arguments.end());
    out.insert(out.end(), more.begin(), more.end());
    return out;
}

// The result of one algorithm.  `failed`: why it has no path; "" if it has one.
struct Row {
    std::string algorithm, failed;
    std::map<std::string, std::string> figures; // by the keys of `metrics`
};

class Comparison {
  public:
    Comparison(Request request, std::vector<Stage> stages)
        : request_(std::move(request)), stages_(std::move(stages)), folder_(request_.output + "/") {}

    // The commands that make the surface, and those of one algorithm, in their order.
    [[nodiscard]] Command surface() const {
        std::vector<std::string> more = request_.inputs;
        more.push_back("--output=" + folder_ + "part.surface");
        return command_of(stages_[0], request_.arguments[0], more);
    }
    [[nodiscard]] std::vector<Command> commands(const std::string& algorithm) const {
        const std::string stem = folder_ + algorithm;
        return {command_of(stages_[1], request_.arguments[1],
                           {"--among=" + algorithm, folder_ + "part.surface", "--output=" + stem + ".surface"}),
                command_of(stages_[2], request_.arguments[2], {stem + ".surface", "--output=" + stem + ".toolpath"}),
                command_of(stages_[3], request_.arguments[3],
                           {"--surface=" + stem + ".surface", stem + ".toolpath", "--format=tsv",
                            "--output=" + stem + ".tsv"}),
                command_of(ask("render"), {},
                           {"--surface=" + stem + ".surface", stem + ".toolpath", "--size=560,420",
                            "--output=" + stem + ".png"})};
    }

    [[nodiscard]] Row run(const std::string& algorithm) const {
        Row out{algorithm, "", {}};
        for (const Command& command : commands(algorithm)) {
            const ProcessEnd ended = run_piped({command}, {""}).front();
            if (ended.code == 0) continue;
            const std::string stage = std::filesystem::path(command[0]).filename().string();
            out.failed = stage + " ended with " + std::to_string(ended.code);
            return out;
        }
        std::ifstream in(folder_ + algorithm + ".tsv");
        for (std::string line; std::getline(in, line);) {
            std::istringstream cells(line);
            std::string key, value;
            if (std::getline(cells, key, '\t') && std::getline(cells, value, '\t')) out.figures[key] = value;
        }
        return out;
    }

  private:
    Request request_;
    std::vector<Stage> stages_; // geodesic, choose, surfpath, metrics
    std::string folder_;
};

std::string figure(const Row& row, const Figure& f) {
    const auto found = row.figures.find(f.key);
    return found == row.figures.end() ? "-" : found->second;
}

std::string as_text(const std::vector<Row>& rows) {
    std::string out = cell("algorithm", 13);
    for (const Figure& f : kFigures) out += cell(f.heading, 11);
    out += "\n";
    for (const Row& row : rows) {
        out += cell(row.algorithm, 13);
        for (const Figure& f : kFigures) out += cell(figure(row, f), 11);
        out += row.failed + "\n";
    }
    return out;
}

std::string as_tsv(const std::vector<Row>& rows) {
    std::string out = "algorithm";
    for (const Figure& f : kFigures) out += std::string("\t") + f.key;
    out += "\tfailed\n";
    for (const Row& row : rows) {
        out += row.algorithm;
        for (const Figure& f : kFigures) out += "\t" + figure(row, f);
        out += "\t" + row.failed + "\n";
    }
    return out;
}

std::string as_page(const std::vector<Row>& rows) {
    std::string out = "<!DOCTYPE html>\n<meta charset=\"utf-8\"><title>paths on one surface</title>\n"
                      "<style>body{font:15px sans-serif;margin:2em}td,th{padding:.2em 1em;text-align:right}"
                      "td:first-child,th:first-child{text-align:left}figure{display:inline-block;margin:1em}</style>\n"
                      "<h1>Paths on one surface</h1>\n<table><tr><th>algorithm</th>";
    for (const Figure& f : kFigures) out += std::string("<th>") + f.heading + "</th>";
    out += "</tr>\n";
    for (const Row& row : rows) {
        out += "<tr><td>" + row.algorithm + "</td>";
        for (const Figure& f : kFigures) out += "<td>" + figure(row, f) + "</td>";
        out += "</tr>\n";
    }
    out += "</table>\n";
    for (const Row& row : rows)
        if (row.failed.empty())
            out += "<figure><img src=\"" + row.algorithm + ".png\" alt=\"" + row.algorithm + "\"><figcaption>" +
                   row.algorithm + "</figcaption></figure>\n";
        else
            out += "<p>" + row.algorithm + ": " + row.failed + "</p>\n";
    return out;
}

// The algorithms in a list such as "fina,hybrid"; all algorithms if the list is empty.
std::vector<std::string> wanted(const std::string& names) {
    if (names.empty()) return {kAlgorithms.begin(), kAlgorithms.end()};
    std::vector<std::string> out;
    std::istringstream in(names);
    for (std::string name; std::getline(in, name, ',');) {
        if (std::find(kAlgorithms.begin(), kAlgorithms.end(), name) == kAlgorithms.end())
            throw Error(Exit::usage,
                        "cannot compare '" + name + "': surfpath has no such algorithm; see 'filum patterns'");
        out.push_back(name);
    }
    return out;
}

// Removes --among from the words and returns its value; "" if it is not given.
std::string take_among(std::vector<std::string>& words) {
    std::string out;
    for (std::size_t i = 0; i < words.size();) {
        const bool apart = words[i] == "--among";
        if (!apart && !words[i].starts_with("--among=")) {
            ++i;
            continue;
        }
        std::size_t last = i;
        out = apart ? value_behind(words, last) : words[i].substr(8);
        words.erase(words.begin() + static_cast<std::ptrdiff_t>(i),
                    words.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    }
    return out;
}

} // namespace

int compare(const std::vector<std::string>& typed) {
    std::vector<std::string> words = typed;
    const auto algorithms = wanted(take_among(words));
    std::vector<Stage> stages;
    for (const char* name : {"geodesic", "choose", "surfpath", "metrics"}) stages.push_back(ask(name));
    Request request = distribute(words, stages);
    if (request.inputs.size() > 1)
        throw Error(Exit::usage, "cannot compare on several surfaces at once; give one file");
    if (request.output == "-") throw Error(Exit::usage, "cannot compare without a folder; give one, as -o paths");
    const Comparison job(request, stages);
    if (request.dry_run) {
        std::string out;
        const auto add = [&](const Command& command) {
            for (std::size_t w = 0; w < command.size(); ++w)
                out += (w > 0 ? " " : "") +
                       shell_word(w > 0 ? command[w] : std::filesystem::path(command[w]).filename().string());
            out += "\n";
        };
        add(job.surface());
        for (const auto& algorithm : algorithms)
            for (const Command& command : job.commands(algorithm)) add(command);
        return show(out), 0;
    }
    std::error_code failed;
    std::filesystem::create_directories(request.output, failed);
    if (failed) throw Error(Exit::io, "cannot make the folder '" + request.output + "': " + failed.message());
    if (const int code = run_piped({job.surface()}, {""}).front().code; code != 0) return code;
    std::vector<Row> rows;
    rows.reserve(algorithms.size());
    for (const auto& algorithm : algorithms) rows.push_back(job.run(algorithm));
    write_file(request.output + "/table.tsv", as_tsv(rows));
    write_file(request.output + "/index.html", as_page(rows));
    show(as_text(rows));
    const bool any = std::any_of(rows.begin(), rows.end(), [](const Row& r) { return r.failed.empty(); });
    return any ? 0 : static_cast<int>(Exit::failure);
}

} // namespace filum::app::filum
