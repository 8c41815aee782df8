// The body and the tool that layers, regions, paths and spans belong to. Private to lib/program/wire.
#pragma once

#include "polygon/region.hpp"
#include "wire/checks.hpp"

namespace filum::wire {

// Reads body and tool of a message. Throws Error(bad_input) for numbers that are too high.
template <class Message, class Data>
void read_owner(const Message& m, Data& to, const char* what) {
    if (m.tool() > polygon::kMostTool) bad_frame(what, "a tool above 1000");
    if (m.body() > polygon::kMostBody) bad_frame(what, "a body above 100000");
    to.body = m.body();
    to.tool = m.tool();
}

template <class Data, class Message>
void put_owner(const Data& from, Message& m) {
    m.set_body(from.body);
    m.set_tool(from.tool);
}

// The bead width of a layer or region, mm. Throws Error(bad_input) unless it is 0 or that of a bead.
template <class Message>
double owner_width(const Message& m, const char* what) {
    if (m.width() != 0 && !(m.width() > 0 && m.width() <= kMaxBead))
        bad_frame(what, "the width of its beads is not between 0 and 10 m");
    return m.width();
}

} // namespace filum::wire
