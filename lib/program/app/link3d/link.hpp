// What every way of linking curves shares: reads Paths, writes the Toolpath and its facts.
#pragma once

#include "cli/command.hpp"
#include "link3d/linker.hpp"
#include "wire/planar.hpp"

namespace filum::app::link3d {

// Gives every region of the input to `linker`, which has the members of filum::link3d::Linker, and writes its spans.
template <class Linker>
void link(Linker linker, const cli::Io& io, const cli::ScanBegin& begin = {}) {
    const auto to = [](const auto& emit) { return [&emit](const toolpath::Span& span) { emit(wire::frame(span)); }; };
    cli::scan_stage(
        io, stream::Payload::paths, stream::Payload::toolpath,
        [&](const stream::RawFrame& frame, const auto& emit, Notes& notes) {
            linker.add(wire::paths(frame), to(emit), notes);
        },
        [&](const auto& emit, Notes& notes) {
            linker.finish(to(emit), notes);
            for (auto& fact : filum::link3d::facts(linker.counts())) {
                fact.stage = io.program;
                emit({stream::Tag::fact, stream::serialise(fact)});
            }
        },
        begin);
}

} // namespace filum::app::link3d
