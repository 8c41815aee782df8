// Any bytes give an error or samples that keep the promises of stressfield::read, and a surface takes them.
#include "base/error.hpp"
#include "stressfield/elements.hpp"
#include "stressfield/read.hpp"
#include "stressfield/stressfield.hpp"

#include <cstdlib>

using namespace filum;

namespace {

surface::Sheet sheet() {
    mesh::Mesh m{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    Notes notes;
    return {surface::connect(std::move(m), notes), {}, {}, {}};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        Notes notes;
        Facts facts;
        const auto s = stressfield::read({reinterpret_cast<const char*>(data), size}, "it", {}, notes);
        if (s.points.empty() || s.cases.empty()) std::abort();
        for (const auto& p : s.points)
            if (!std::isfinite(p.x + p.y + p.z)) std::abort();
        for (const auto& e : s.elements)
            if (e.first + stressfield::node_count(e.shape) > s.nodes.size()) std::abort();
        for (const auto n : s.nodes)
            if (n >= s.points.size()) std::abort();
        for (const auto& c : s.cases)
            if (c.tensors.size() != s.points.size() &&
                (c.directions.size() != s.points.size() || c.principals.size() != s.points.size()))
                std::abort();
        auto onto = sheet();
        stressfield::add(onto, s, {}, 1, notes, facts);
    } catch (const Error&) { // said clearly
    }
    return 0;
}
