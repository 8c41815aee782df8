// assemble - puts toolpaths into one job
// reads:  Toolpath streams
// writes: Toolpath
// memory: one toolpath
#include "cli/output.hpp"
#include "mesh/place.hpp"
#include "toolpath/assembly.hpp"
#include "wire/planar.hpp"

#include <cmath>
#include <memory>

namespace {

using namespace filum;

struct Options {
    toolpath::AssemblyOptions job;
    std::vector<double> rotate_deg{0, 0, 0}, translate{0, 0, 0}; // mm
};

cli::Spec spec(Options& o) {
    return {
        .name = "assemble",
        .synopsis = "put toolpaths into one job",
        .description = cli::kDescription,
        .in = cli::reads(stream::Payload::toolpath),
        .out = cli::writes(stream::Payload::toolpath),
        .memory = "one toolpath",
        .options = {cli::Option{"lift", &o.job.lift, "MM", "how high the tool travels from one to the next"}
                        .within(0, 1e4)
                        .a_limit(),
                    cli::Option{"tools", &o.job.tools, "N,...",
                                "tool of each toolpath in turn; the last one applies to all that follow"}
                        .within(0, 1000),
                    cli::Option{"rotate", &o.rotate_deg, "X,Y,Z", "degrees to turn about the x axis, then y, then z"}
                        .numbers(3)
                        .within(-360, 360),
                    cli::Option{"translate", &o.translate, "X,Y,Z", "distance to move by, mm"}.numbers(3).within(-1e7,
                                                                                                                 1e7)},
        .examples =
            {{"geodesic part.stl --source plane:1,0,0,4.5 > part.surface; surfpath fina part.surface > a.toolpath; "
              "surfpath ortheo part.surface --ply 1 --offset 0.2 > b.toolpath; assemble a.toolpath b.toolpath > "
              "woven.toolpath",
              "two plies across each other, a woven grid"}},
        .see_also = {"surfpath", "link3d", "postproc"},
        .arguments = "[INPUT...]",
        .many_inputs = true,
    };
}

void run(const Options& o, const cli::Io& io) {
    for (const double tool : o.job.tools)
        if (tool != std::floor(tool)) throw Error(Exit::usage, "cannot use '--tools': a tool is a whole number");
    const auto names = io.inputs.empty() ? std::vector<std::string>{"-"} : io.inputs;
    std::vector<std::unique_ptr<stream::Reader>> readers;
    std::vector<const stream::Header*> before;
    for (const auto& name : names) {
        readers.push_back(std::make_unique<stream::Reader>(name, stream::Payload::toolpath));
        before.push_back(&readers.back()->header());
    }
    cli::Output output(io, cli::header(io, stream::Payload::toolpath, before));
    toolpath::AssemblyOptions options = o.job;
    options.place = mesh::rigid(o.rotate_deg, o.translate);
    toolpath::Assembly job(options);
    for (const auto& reader : readers) {
        job.begin();
        while (auto frame = reader->next()) {
            if (frame->tag != stream::Tag::span) {
                output.write(*frame);
                continue;
            }
            for (const auto& span : job.add(wire::span(*frame))) output.write(wire::frame(span));
        }
    }
    output.add(Facts{{"", "toolpaths", static_cast<double>(names.size()), ""}});
    output.close();
}

} // namespace

int main(int argc, char** argv) { return cli::main<Options>(argc, argv, spec, run); }
