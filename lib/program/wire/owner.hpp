// The body and the tool that layers, regions, paths and spans belong to, and the size of its beads. Private to
// lib/program/wire.
#pragma once

#include "polygon/region.hpp"
#include "wire/checks.hpp"

#include <algorithm>

namespace filum::wire {

// The bead width of a layer or region, mm. Throws Error(bad_input) unless it is 0 or that of a bead.
template <class Message>
double owner_width(const Message& m, const char* what) {
    if (m.width() != 0 && !(m.width() > 0 && m.width() <= kMaxBead))
        bad_frame(what, "the width of its beads is not between 0 and 10 m");
    return m.width();
}

// The number of layers that a layer or region is high; `top` is the uppermost. Throws Error(bad_input) for more than
// there are below, or more than kMostLayers.
template <class Message>
std::uint32_t owner_layers(const Message& m, std::uint32_t top, const char* what) {
    const std::uint32_t layers = std::max(m.layers(), 1U);
    if (layers > polygon::kMostLayers) bad_frame(what, "it is more than 16 layers high");
    if (layers - 1 > top) bad_frame(what, "it is higher than the number of its layer allows");
    return layers;
}

// Reads body and tool of a message, and what else it has of: width of the beads, layers that it is high, layers that
// its body skips. The number of its layer must be known. Throws Error(bad_input) for numbers that are too high.
template <class Message, class Data>
void read_owner(const Message& m, Data& to, const char* what) {
    if (m.tool() > polygon::kMostTool) bad_frame(what, "a tool above 1000");
    if (m.body() > polygon::kMostBody) bad_frame(what, "a body above 100000");
    to.body = m.body();
    to.tool = m.tool();
    if constexpr (requires { m.skipped(); }) {
        std::uint32_t top = 0;
        if constexpr (requires { to.index; })
            top = to.index;
        else
            top = to.layer;
        if (m.skipped() > top) bad_frame(what, "its body skips more layers than there are below");
        to.skipped = m.skipped();
        if constexpr (requires { m.layers(); }) {
            to.width = owner_width(m, what);
            to.layers = owner_layers(m, top, what);
        }
    }
}

template <class Data, class Message>
void put_owner(const Data& from, Message& m) {
    m.set_body(from.body);
    m.set_tool(from.tool);
    if constexpr (requires { m.skipped(); }) m.set_skipped(from.skipped);
    if constexpr (requires { m.layers(); }) {
        m.set_width(from.width);
        m.set_layers(from.layers > 1 ? from.layers : 0); // a plain height is not written
    }
}

} // namespace filum::wire
