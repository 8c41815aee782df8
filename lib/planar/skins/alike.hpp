// Layers and regions with the same content, as those of a box or a tower: their areas are made once.
// Private to lib/planar/skins.
#pragma once

#include "parallel/parallel.hpp"
#include "polygon/content_hash.hpp"

#include <vector>

namespace filum::skins {

using polygon::Loops;

// For each of the layers the first one with the same outlines.
inline std::vector<std::size_t> alike(const std::vector<Loops>& layers) {
    return polygon::first_alike(
        layers.size(),
        [&](std::size_t i) {
            polygon::ContentHash h;
            h.add(layers[i]);
            return h.value();
        },
        [&](std::size_t i, std::size_t k) { return polygon::same(layers[i], layers[k]); });
}

// For each region the first one with the same outline and the same numbers.
template <class Outline, class Numbers>
std::vector<std::size_t> alike(std::size_t count, Outline&& outline, Numbers&& numbers) {
    return polygon::first_alike(
        count,
        [&](std::size_t i) {
            polygon::ContentHash h;
            for (const double x : numbers(i)) h.add(x);
            h.add(outline(i));
            return h.value();
        },
        [&](std::size_t i, std::size_t k) {
            return numbers(i) == numbers(k) && polygon::same(outline(i), outline(k));
        });
}

// Sets out[i] = make(i) for the first ones of regions that are alike, and copies the others.
template <class Make>
void make_once(const std::vector<std::size_t>& first, std::vector<Loops>& out, Make&& make) {
    parallel::for_chunks(first.size(), 1, 0, [&](std::size_t i, std::size_t) {
        if (first[i] == i) out[i] = make(i);
    });
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] != i) out[i] = out[first[i]];
}

} // namespace filum::skins
