#include "app/collide/things.hpp"

#include "mesh/place.hpp"
#include "mesh/step/step.hpp"
#include "stream/crc32c.hpp"

#include <cmath>
#include <cstdio>

namespace filum::app::collide {

using collision::Obstacle;
using geom::Vec3;

void check_place(const Vec3& p, const std::string& what) {
    constexpr double most = mesh::kMaxCoordinate;
    if (!(std::abs(p.x) <= most) || !(std::abs(p.y) <= most) || !(std::abs(p.z) <= most))
        throw Error(Exit::bad_input, "cannot use " + what + ": a coordinate is beyond 10000 m; is its unit mm?");
}

void Things::meshes(const std::string& files, Obstacle against) {
    if (!files.empty() && ("," + files + ",").find(",,") != std::string::npos)
        throw Error(Exit::usage, "cannot use '" + files + "' as names of files: one is empty");
    std::uint32_t crc = 0;
    for (std::size_t at = 0; !files.empty() && at <= files.size();) {
        const std::size_t comma = std::min(files.find(',', at), files.size());
        const std::string path = files.substr(at, comma - at);
        at = comma + 1;
        const mesh::Bytes bytes = mesh::load(path);
        crc = stream::crc32c(crc, bytes.data.get(), bytes.size);
        const mesh::File file = mesh::step::read(bytes.view(), mesh::spoken_name(path));
        for (const Vec3& p : file.mesh.vertices) check_place(p, mesh::spoken_name(path));
        notes.insert(notes.end(), file.notes.begin(), file.notes.end());
        collision::add(file.mesh, solids[static_cast<std::size_t>(against)]);
    }
    char text[9];
    std::snprintf(text, sizeof text, "%08x", crc);
    const char* name = collision::kAgainstNames[static_cast<std::size_t>(against)];
    if (!files.empty()) settings.push_back({std::string(name) + "_crc32c", text, true});
}

Things::Things(const std::string& part, const std::string& fixture) {
    meshes(part, Obstacle::part);
    meshes(fixture, Obstacle::fixture);
}

machine::Profile profile_of(const std::string& name, const std::string& set, const machine::HeadChoice& head) {
    if (name.empty() && !set.empty()) throw Error(Exit::usage, "cannot use --set without --machine");
    machine::Profile profile;
    if (!name.empty()) profile = machine::load_profile(name, set);
    const bool own = !name.empty() && head.name == "ordinary";
    const auto chosen = [&](const machine::Head& of) { return own ? machine::altered(of, head) : machine::head(head); };
    profile.head = chosen(profile.head);
    for (auto& [tool, with] : profile.own) {
        machine::Profile changed = *with;
        changed.head = chosen(with->head);
        with = std::make_shared<const machine::Profile>(std::move(changed));
    }
    return profile;
}

collision::Heads heads_of(const machine::Profile& profile) { return machine::heads(profile); }

collision::Machine machine_of(const machine::Profile& profile) {
    return {heads_of(profile), profile.travel.lift, profile.travel.min_length, profile.axes.active()};
}

void add_settings(const machine::Head& head, cli::Io& io) {
    for (const auto& [name, value, changed] : machine::settings(head)) io.settings.push_back({name, value, changed});
}

void write_places(const std::string& file, const collision::ReportInput& answer) {
    if (file.empty()) return;
    stream::Sink sink(file, stream::Sink::Content::text);
    sink.write(collision::places(answer));
    sink.commit();
}

} // namespace filum::app::collide
