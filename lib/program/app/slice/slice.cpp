#include "app/slice/slice.hpp"

#include "app/modifier/modifier.hpp"
#include "app/slice/bodies.hpp"
#include "app/slice/fitting.hpp"
#include "app/slice/heights.hpp"
#include "app/slice/plate.hpp"
#include "parallel/parallel.hpp"
#include "polygon/clip.hpp"
#include "slice/bores.hpp"
#include "wire/planar.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>

namespace filum::app::slice {

namespace {

struct Job {
    const Options& o;
    std::vector<BedPart>& parts;
    std::span<const filum::slice::Level> levels;
    LayerRange wanted;
    std::atomic<bool> holed = false;         // a layer has a hole
    std::vector<std::vector<double>> kept{}; // of several bodies, per body and layer: mm2 that are left of it
    HighLayers high{};

    // The width of the beads of a part in a layer, mm; 0: as the stages' options say.
    [[nodiscard]] double width(const BedPart& part, std::size_t layer) const {
        const double first = o.first_layer_width;
        return first > 0 && above_bed(layer) == 0 ? first : part.width;
    }

    [[nodiscard]] bool bodies() const { return !o.body.empty() && (parts.size() > 1 || parts[0].layers > 1); }

    // 0 for the layer on the bed, which has an elephant's foot, and 1 for layers above.  The lowest layer of a print
    // that continues another (from_layer) is not on the bed.
    [[nodiscard]] std::uint32_t above_bed(std::size_t layer) const {
        return layer == wanted.first && o.from_layer == 0 ? 0 : 1;
    }
};

// Moves notes on wanted layers to `to`, and numbers their layers from the first wanted one.  Notes without a layer are
// moved, too.
void take_notes(const Job& job, const BedPart& part, Notes found, Notes& to) {
    const auto first = static_cast<std::int64_t>(job.wanted.first), last = static_cast<std::int64_t>(job.wanted.last);
    for (Note& note : as_placed(part, std::move(found))) {
        if (note.layer >= 0 && (note.layer < first || note.layer >= last)) continue;
        if (note.layer >= 0) note.layer -= first;
        to.push_back(std::move(note));
    }
}

// Finds bores that some layers leave open.  This needs the layers above and below, so it cannot be done chunk by chunk.
void find_bores(Job& job, int threads, Notes& notes) {
    if (job.o.compensation.holes == 0) return;
    for (BedPart& part : job.parts) {
        std::vector<polygon::Loops> contours(part.sweep.levels.size());
        parallel::for_chunks(part.sweep.chunks(), 1, threads, [&](std::size_t chunk, std::size_t) {
            for (polygon::Layer& layer : filum::slice::cut(part.sweep, chunk).layers)
                contours[layer.index] = std::move(layer.contours);
        });
        Notes own;
        part.bores = filum::slice::open_bores(contours, own);
        take_notes(job, part, std::move(own), notes);
    }
}

// A layer of a body that is several layers high. Below --from-layer nothing is left of it to rest on.
polygon::Layer high_layer(const Job& job, const HighLayer& high) {
    const BedPart& body = job.parts[high.body];
    const auto index = static_cast<std::uint32_t>(high.last - job.wanted.first);
    polygon::Layer out{index,     job.levels[high.last].z - job.wanted.down, high.height, high.plane - job.wanted.down,
                       high.area, static_cast<std::uint32_t>(high.body),     body.tool,   body.width};
    out.layers = std::min(static_cast<std::uint32_t>(high.last - high.first + 1), index + 1);
    out.skipped = std::min(high.skipped, index);
    return out;
}

// The contours of a layer with those of all copies, for each body.  Later bodies are cut from earlier ones; a note
// reports what that takes.
std::vector<polygon::Layer> body_layers(Job& job, std::size_t i, std::vector<polygon::Loops> contours, Notes& notes) {
    const auto& level = job.levels[i];
    const auto index = static_cast<std::uint32_t>(i - job.wanted.first);
    std::vector<std::uint32_t> tools;
    for (const BedPart& part : job.parts) tools.push_back(part.tool);
    cut_by_later(contours, tools, level.height, job.o.slice.hairline, index, notes);
    job.high.share(i, job.parts, contours);
    std::vector<polygon::Layer> out;
    for (std::size_t b = 0; b < contours.size(); ++b) {
        if (const HighLayer* high = job.high.of(b, i); high != nullptr && high->last == i && !high->area.empty()) {
            job.kept[b][i] = polygon::signed_area(high->area);
            out.push_back(high_layer(job, *high));
            continue;
        }
        job.kept[b][i] = polygon::signed_area(contours[b]);
        if (contours[b].empty() && !(b + 1 == contours.size() && out.empty())) continue;
        out.push_back({index, level.z - job.wanted.down, level.height, level.plane - job.wanted.down,
                       std::move(contours[b]), static_cast<std::uint32_t>(b), job.parts[b].tool,
                       job.width(job.parts[b], i)});
    }
    return out;
}

// The layers of a chunk, with all parts together, or one after the other if they are bodies of one part.
std::vector<stream::RawFrame> cut_all(Job& job, std::size_t chunk, Notes& notes) {
    const std::size_t first = chunk * filum::slice::kChunk,
                      n = std::min(job.levels.size() - first, filum::slice::kChunk);
    std::vector<std::vector<polygon::Loops>> contours(job.bodies() ? job.parts.size() : 1,
                                                      std::vector<polygon::Loops>(n));
    for (std::size_t p = 0; p < job.parts.size(); ++p) {
        BedPart& part = job.parts[p];
        if (chunk >= part.sweep.chunks()) continue;
        filum::slice::SlicedChunk cut =
            part.carved ? slice::cut(*part.carved, chunk) : filum::slice::cut(part.sweep, chunk);
        take_notes(job, part, std::move(cut.notes), notes);
        for (polygon::Layer& layer : cut.layers) {
            part.area[layer.index] = polygon::signed_area(layer.contours);
            if (job.o.compensation.any()) {
                if (polygon::split(layer.contours).part.size() < layer.contours.size()) job.holed = true;
                Notes own;
                const polygon::Loops bores = part.bores.empty() ? polygon::Loops{} : part.bores[layer.index];
                layer.contours = filum::slice::compensated(layer.contours, bores, job.o.compensation,
                                                           job.above_bed(layer.index), own);
                for (Note& note : own) note.layer = layer.index;
                take_notes(job, part, std::move(own), notes);
            }
            add_copies(layer.contours, part.at, contours[job.bodies() ? p : 0][layer.index - first]);
        }
    }
    std::vector<stream::RawFrame> frames;
    for (std::size_t i = std::max(first, job.wanted.first); i < std::min(first + n, job.wanted.last); ++i) {
        if (job.bodies()) {
            std::vector<polygon::Loops> each;
            each.reserve(contours.size());
            for (auto& of_body : contours) each.push_back(std::move(of_body[i - first]));
            for (const polygon::Layer& layer : body_layers(job, i, std::move(each), notes))
                frames.push_back(wire::frame(layer));
            continue;
        }
        const auto& level = job.levels[i];
        const auto index = static_cast<std::uint32_t>(i - job.wanted.first);
        frames.push_back(wire::frame(polygon::Layer{index, level.z - job.wanted.down, level.height,
                                                    level.plane - job.wanted.down, std::move(contours[0][i - first]), 0,
                                                    job.parts[0].tool, job.width(job.parts[0], i)}));
    }
    return frames;
}

// Whether a note reports a layer without this body that has another one.
auto of_other_bodies(const Job& job) {
    return [&job](const Note& note) {
        return note.code == NoteCode::layer_empty &&
               std::any_of(job.parts.begin(), job.parts.end(), [&](const BedPart& part) {
                   return static_cast<std::size_t>(note.layer) < part.area.size() &&
                          part.area[static_cast<std::size_t>(note.layer)] > 0;
               });
    };
}

void tell_idle(const Job& job, const cli::Io& io) {
    if (!job.holed) io.idle("hole-compensation", "no layer has a hole");
    if (job.wanted.first == 0) io.idle("cut-below", "nothing lies below");
    if (job.wanted.last == job.levels.size()) io.idle("cut-above", "nothing lies above");
}

} // namespace

void run(const Options& o, const cli::Io& io) {
    cli::Io self = io;
    Notes notes;
    std::vector<BedPart> parts = read_parts(o, self);
    if (o.body.empty()) std::ranges::move(fitting_parts(parts, io.threads), std::back_inserter(notes));
    auto objects = place_on_bed(parts, o, io, notes);
    const auto levels = prepare(parts, o, io.threads, notes);
    Job job{o, parts, levels, wanted(levels, o)};
    if (objects.empty()) { // a single part
        auto [map, unit] = parts[0].placement;
        map.t[2] -= job.wanted.down;
        self.settings.push_back(modifier::placement_setting(map));
        if (unit != 1) self.settings.push_back(modifier::unit_setting(unit));
    }
    auto header = cli::header(self, stream::Payload::layers);
    header.history.back().objects = std::move(objects);
    if (job.bodies())
        job.kept.assign(parts.size(), std::vector<double>(levels.size(), 0));
    else
        header.expected = job.wanted.last - job.wanted.first;
    find_bores(job, io.threads, notes);
    if (job.bodies()) {
        const std::size_t bottom = job.wanted.first - static_cast<std::size_t>(o.from_layer);
        job.high = HighLayers(parts, levels, bottom, job.wanted.last, o, io.threads);
    }
    const std::size_t chunks = (levels.size() + filum::slice::kChunk - 1) / filum::slice::kChunk;
    cli::source_stage(
        io, header, chunks, std::move(notes),
        [&](std::size_t chunk, Notes& found) { return cut_all(job, chunk, found); },
        [&](Notes& last) {
            tell_idle(job, io);
            if (job.bodies()) tell_hidden(parts, job.kept, levels, last);
            for (const BedPart& part : parts) {
                if (part.carved) continue; // its mesh includes material that is cut away
                Notes found;
                filum::slice::compare(part.sweep, part.measured, part.area, io.threads, found);
                if (job.bodies()) std::erase_if(found, of_other_bodies(job));
                take_notes(job, part, std::move(found), last);
            }
        });
}

} // namespace filum::app::slice
