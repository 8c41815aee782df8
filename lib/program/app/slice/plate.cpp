#include "app/slice/plate.hpp"

#include "app/slice/bodies.hpp"
#include "app/slice/grid.hpp"
#include "app/slice/sizes.hpp"
#include "base/number.hpp"
#include "base/printable.hpp"
#include "cli/step_options.hpp"
#include "geom/hull.hpp"
#include "machine/profile.hpp"
#include "plate/plate.hpp"
#include "stream/crc32c.hpp"

#include <algorithm>
#include <cmath>

namespace filum::app::slice {

namespace {

using filum::slice::kLift;
using filum::slice::Level;

// Cuts away the negative bodies of a placed file, and puts the rest on the bed.
void cut_away(mesh::File& file, const Options& o, int threads, BedPart& part) {
    for (mesh::Body& b : file.bodies)
        if (b.what == mesh::Body::Purpose::negative) mesh::move(b.mesh, part.placement.map);
    const double step = (o.slice.adaptive ? o.slice.min_layer_height : o.slice.layer_height) / 2;
    const auto carve_again = [&](Notes& notes) { part.carved = carve(file, o.slice.hairline, step, threads, notes); };
    Notes found;
    carve_again(found);
    const double up = mesh::bounds(file.mesh).lo.z - part.carved->box.lo.z;
    if (o.place.on_bed && !o.place.keep_z && up != 0) {
        const geom::Affine on{.t = {0, 0, up}};
        mesh::move(file.mesh, on);
        for (mesh::Body& b : file.bodies) mesh::move(b.mesh, on);
        part.placement.map = geom::then(part.placement.map, on);
        found.clear();
        carve_again(found);
    }
    std::ranges::move(found, std::back_inserter(part.notes));
}

BedPart read_part(const std::string& path, const Options& o, const cli::Io& io, bool several, std::string& crc) {
    const mesh::Bytes bytes = mesh::load(path);
    crc += (crc.empty() ? "" : ",") + stream::crc32c_text(bytes.view());
    mesh::File file = mesh::step::read(bytes.view(), mesh::spoken_name(path), o.step, static_cast<int>(o.plate));
    if (!several) cli::step_idle(io, file.kind == mesh::Kind::step);
    if (file.kind != mesh::Kind::threemf) io.idle("plate", "the file is no project with plates");
    BedPart out;
    out.notes = std::move(file.notes);
    if (!file.materials.empty()) out.notes.push_back({.code = NoteCode::materials_as_one});
    check_precision(file.mesh, out.notes);
    mesh::Placement placement = o.place;
    placement.scale = enlarged(o.place.scale, o.shrinkage);
    if (several) { // these apply to all parts together, not to each
        placement.center.clear();
        placement.translate = {0, 0, o.place.translate[2]};
    }
    out.placement = mesh::place(file.mesh, placement, mesh::states_unit(file.kind), out.notes);
    out.name = label(path);
    if (is_carved(file)) {
        cut_away(file, o, io.threads, out);
        file.mesh = within_heights(std::move(file.mesh), out.carved->box);
    }
    out.box = out.carved ? out.carved->box : mesh::bounds(file.mesh);
    const bool unit_known = mesh::states_unit(file.kind) || o.place.unit != "mm" || o.place.scale != std::vector{1.0};
    check_size(out.box, unit_known, out.notes);
    check_bed(out.box, o);
    if (several) {
        std::vector<Vec2> flat;
        for (const geom::Vec3& v : file.mesh.vertices) flat.push_back(v.xy());
        out.outline = geom::convex_hull(flat);
    }
    Notes of_heights; // dropped for a carved part: this mesh only gives the heights, and `carved` has notes of its own
    out.part = std::make_unique<filum::slice::Part>(
        filum::slice::make_part(std::move(file.mesh), out.carved ? of_heights : out.notes, o.slice.hairline));
    return out;
}

// The names of all copies of all parts, each different: the copies of "a" are a, a_2, a_3.
std::vector<std::string> names_of(const std::vector<BedPart>& parts) {
    std::vector<std::string> words;
    for (const BedPart& part : parts) words.insert(words.end(), part.at.size(), part.name);
    return told_apart(words);
}

// Packs the things with the first of the spacings `tries` at which all find a place.  At each spacing the things are
// tried as they are, then all turned alike, then each turned by itself.  `taken`: the last spacing that was tried.  If
// some things find no place, the result lists them.
plate::Packing packed(const std::vector<plate::Thing>& things, const std::vector<plate::Spacing>& tries, Vec2 size,
                      plate::Spacing& taken) {
    plate::Packing out;
    for (const plate::Spacing& spacing : tries) {
        taken = spacing;
        for (const plate::QuarterTurns turn :
             {plate::QuarterTurns::none, plate::QuarterTurns::all, plate::QuarterTurns::each}) {
            out = plate::pack(things, spacing, size, turn);
            if (out.left.empty()) return out;
        }
    }
    return out;
}

[[noreturn]] void refuse(const plate::Packing& packed, const std::vector<std::string>& names,
                         const plate::Spacing& spacing, const std::string& machine, Vec2 size) {
    constexpr std::size_t kNamed = 3; // so that the message stays short
    std::string left;
    for (std::size_t k = 0; k < std::min(kNamed, packed.left.size()); ++k)
        left += (k == 0 ? "'" : ", '") + names[packed.left[k]] + "'";
    if (packed.left.size() > kNamed) left += " and " + std::to_string(packed.left.size() - kNamed) + " more";
    throw Error(Exit::bad_input, "cannot place " + left + ": " + std::to_string(packed.left.size()) + " of " +
                                     std::to_string(names.size()) + " parts find no room on the bed of '" + machine +
                                     "', " + size_text(size) + ", " + fixed_text(std::max(spacing.x, spacing.y), 1) +
                                     " mm apart; print them by themselves, or give a smaller --apart");
}

// Adds a note if the parts are nearer to each other than the head needs.
void tell_spacing(const plate::Spacing& taken, const std::vector<plate::Spacing>& tries, Notes& notes) {
    if (taken.clear) return;
    const double wanted = std::max(tries.front().x, tries.front().y), got = std::max(taken.x, taken.y);
    notes.push_back({.code = NoteCode::parts_too_near, .amount = std::min(wanted, got)});
}

void tell_turned(const plate::Packing& packed, Notes& notes) {
    double turned = 0;
    for (const plate::Place& p : packed.place) turned += p.quarters == 0 ? 0 : 1;
    if (turned > 0) notes.push_back({.code = NoteCode::parts_turned, .amount = turned});
}

// The places of all parts, packed on the bed.  Throws Error(bad_input) if a part finds no place.
std::vector<plate::Place> packed_places(const std::vector<BedPart>& parts, const Options& o,
                                        const machine::Profile& profile, const std::vector<std::string>& names,
                                        Notes& notes) {
    const double wider = std::max(0.0, o.compensation.xy); // mm at each side
    const Vec2 size{profile.bed.x_max - profile.bed.x_min - 2 * wider,
                    profile.bed.y_max - profile.bed.y_min - 2 * wider};
    std::vector<plate::Thing> things;
    for (const BedPart& part : parts)
        for (std::size_t k = 0; k < part.at.size(); ++k)
            things.push_back({part.outline, part.box.hi.z - part.box.lo.z});
    auto tries = o.apart.empty() ? plate::spacings(things, profile.head)
                                 : std::vector{plate::spacing(o.apart[0], things, profile.head)};
    for (plate::Spacing& s : tries) {
        s.x += 2 * wider;
        s.y += 2 * wider;
    }
    plate::Spacing taken;
    plate::Packing places = packed(things, tries, size, taken);
    if (!places.left.empty()) refuse(places, names, taken, profile.name, size);
    tell_spacing(taken, tries, notes);
    tell_turned(places, notes);
    return std::move(places.place);
}

} // namespace

// Firmware takes no other characters in names.
std::string label(const std::string& path) {
    std::string name = path.substr(path.find_last_of('/') + 1);
    const auto dot = name.find_last_of('.');
    if (dot != 0 && dot != std::string::npos) name.resize(dot);
    return path == "-" ? "part" : plain_word(name, "part");
}

std::vector<double> enlarged(const std::vector<double>& scale, const std::vector<double>& shrinkage) {
    if (shrinkage.size() != 1 && shrinkage.size() != 3)
        throw Error(Exit::usage, "cannot use --shrinkage: it takes one number or three");
    if (scale.size() != 1 && scale.size() != 3) return scale; // refused when the part is placed
    std::vector<double> out(std::max(scale.size(), shrinkage.size()));
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = scale[k % scale.size()] / (1 - shrinkage[k % shrinkage.size()] / 100);
    return out;
}

std::vector<BedPart> read_parts(const Options& o, cli::Io& self) {
    if (!o.body.empty()) return read_bodies(o, self);
    const auto inputs = self.inputs.empty() ? std::vector<std::string>{"-"} : self.inputs;
    const bool several = inputs.size() > 1 || o.copies > 1 || in_grid(o);
    std::vector<BedPart> out;
    std::string crc;
    out.reserve(inputs.size());
    for (const std::string& path : inputs) out.push_back(read_part(path, o, self, several, crc));
    self.settings.push_back({"input_crc32c", crc});
    const std::size_t each = copies(o, inputs.size());
    for (BedPart& part : out) part.at.assign(each, {});
    return out;
}

std::vector<stream::Object> place_on_bed(std::vector<BedPart>& parts, const Options& o, const cli::Io& io,
                                         Notes& notes) {
    if (!o.body.empty() && parts.size() > 1) { // the bodies of a part stay together
        std::vector<BedPart> whole;
        whole.push_back(joint(parts));
        auto out = place_on_bed(whole, o, io, notes);
        for (BedPart& part : parts) part.at = whole.front().at;
        return out;
    }
    if (parts.size() == 1 && parts[0].at.size() == 1 && !in_grid(o)) {
        io.idle("apart", "there is one part");
        return {};
    }
    const machine::Profile profile = machine_of(o);
    auto names = names_of(parts);
    if (in_grid(o)) io.idle("apart", "the parts stand in a grid");
    const auto places = in_grid(o) ? in_places(parts, o, names) : packed_places(parts, o, profile, names, notes);
    Vec2 to = o.place.center.empty() ? profile.bed.centre() : Vec2{o.place.center[0], o.place.center[1]};
    to = to + Vec2{o.place.translate[0], o.place.translate[1]};
    std::vector<stream::Object> out;
    for (BedPart& part : parts)
        for (plate::Place& at : part.at) {
            at = places[out.size()];
            at.move = at.move + to;
            stream::Object object{names[out.size()], {}, {}, part.box.hi.z};
            for (const Vec2& p : part.outline) {
                object.x.push_back(at(p).x);
                object.y.push_back(at(p).y);
            }
            out.push_back(std::move(object));
        }
    return out;
}

void add_copies(const polygon::Loops& loops, const std::vector<plate::Place>& at, polygon::Loops& to) {
    for (const plate::Place& place : at)
        for (std::size_t i = 0; i < loops.size(); ++i) {
            for (const Vec2& p : loops[i]) to.points.push_back(place(p));
            to.close();
        }
}

Notes as_placed(const BedPart& part, Notes notes) {
    for (Note& note : notes) {
        note.count *= part.at.size();
        note.amount *= static_cast<double>(part.at.size());
        const Vec2 at = part.at[0]({note.x, note.y});
        note.x = at.x;
        note.y = at.y;
    }
    return notes;
}

std::vector<Level> prepare(std::vector<BedPart>& parts, const Options& o, int threads, Notes& notes) {
    if (parts.size() == 1) {
        parts[0].sweep = filum::slice::prepare(*parts[0].part, o.slice, threads, parts[0].notes);
    } else {
        mesh::Mesh all; // used only for the levels
        for (const BedPart& part : parts) mesh::append(part.part->mesh, all);
        const std::vector<Level> levels = filum::slice::levels(all, o.slice, notes);
        for (BedPart& part : parts) {
            const double top = part.box.hi.z;
            std::vector<Level> own;
            for (const Level& l : levels)
                if (l.plane + 2 * kLift <= top) own.push_back(l);
            if (own.empty()) { // the part has a single layer, or is refused
                Options low = o;
                low.slice.adaptive = false;
                own = filum::slice::levels(part.part->mesh, low.slice, part.notes);
            }
            part.sweep = filum::slice::sweep_over(*part.part, o.slice, std::move(own), threads);
        }
    }
    const BedPart* most = &parts[0];
    for (const BedPart& part : parts)
        if (part.sweep.levels.size() > most->sweep.levels.size()) most = &part;
    for (BedPart& part : parts) {
        if (part.carved)
            sweep(*part.carved, o.slice, part.sweep.levels, threads);
        else
            part.measured = filum::slice::judge(part.sweep, threads, part.notes);
        for (Note& note : as_placed(part, std::move(part.notes))) notes.push_back(std::move(note));
        part.area.assign(part.sweep.levels.size(), 0);
    }
    return most->sweep.levels;
}

LayerRange wanted(std::span<const Level> levels, const Options& o) {
    const auto first_above = [&](double z) {
        const auto at =
            std::find_if(levels.begin(), levels.end(), [&](const Level& l) { return l.z - l.height / 2 > z; });
        return static_cast<std::size_t>(at - levels.begin());
    };
    LayerRange out{0, levels.size(), 0};
    if (!o.cut_below.empty()) out.first = first_above(o.cut_below[0]);
    if (!o.cut_above.empty()) out.last = first_above(o.cut_above[0]);
    if (out.first > 0 && out.first < levels.size()) out.down = levels[out.first - 1].z;
    out.first += static_cast<std::size_t>(o.from_layer);
    if (out.first >= out.last)
        throw Error(Exit::bad_input, "cannot slice what is left: none of the " + std::to_string(levels.size()) +
                                         " layers lies there; check --cut-below, --cut-above and --from-layer");
    return out;
}

} // namespace filum::app::slice
