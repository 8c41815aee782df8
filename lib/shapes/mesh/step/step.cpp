#include "mesh/step/step.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/step/answer.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace filum::mesh::step {

namespace fs = std::filesystem;

namespace {

// The program is in lib/filum, beside the folder of the commands or above it.
fs::path reader() {
    std::error_code none;
    fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
    for (int up = 0; up < 2; ++up) {
        folder = folder.parent_path();
        const fs::path file = folder / "lib" / "filum" / "read-step";
        if (::access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

[[noreturn]] void failed(const std::string& what) {
    throw Error(Exit::failure, "cannot run the reader of STEP files: " + what + ": " + std::strerror(errno));
}

// An anonymous file in memory.
class Memory {
  public:
    Memory() : fd(::memfd_create("filum-step", MFD_CLOEXEC)) {
        if (fd < 0) failed("memory");
    }
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    ~Memory() { ::close(fd); }

    void fill(std::string_view bytes) const {
        for (std::size_t at = 0; at < bytes.size();) {
            const ssize_t n = ::write(fd, bytes.data() + at, bytes.size() - at);
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) failed("memory");
            at += static_cast<std::size_t>(n);
        }
        ::lseek(fd, 0, SEEK_SET);
    }
    [[nodiscard]] std::string content() const {
        std::string out(static_cast<std::size_t>(::lseek(fd, 0, SEEK_END)), '\0');
        for (std::size_t at = 0; at < out.size();) {
            const ssize_t n = ::pread(fd, out.data() + at, out.size() - at, static_cast<off_t>(at));
            if (n < 0 && errno == EINTR) continue;
            if (n <= 0) failed("memory");
            at += static_cast<std::size_t>(n);
        }
        return out;
    }

    int fd;
};

// Runs the program with `in` as its standard input and `out` as its descriptor 3; it gets no other file. Returns its
// status, as waitpid does.
int run(const fs::path& program, const Tessellation& how, const Memory& in, const Memory& out) {
    const std::string deflection = shortest_text(how.deflection), angle = shortest_text(how.angle_deg);
    std::string words[] = {program.string(), deflection, angle};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, in.fd, 0);
    ::posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, out.fd, 3);
    pid_t child = -1;
    errno = ::posix_spawn(&child, arguments[0], &actions, nullptr, arguments, environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (child < 0) failed(program.string());
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) failed(program.string());
    return status;
}

template <class T>
void take(std::string_view& from, std::vector<T>& to, std::size_t count) {
    to.resize(count);
    if (count > 0) std::memcpy(static_cast<void*>(to.data()), from.data(), count * sizeof(T));
    from.remove_prefix(count * sizeof(T));
}

// Decodes the mesh of an answer.  Checks every size and index in it.
mesh::Mesh unpacked(const Answer& head, std::string_view body) {
    static_assert(sizeof(mesh::Vec3) == 24 && sizeof(mesh::Triangle) == 12);
    const bool plausible = head.vertices < body.size() && head.triangles < body.size() &&
                           body.size() == 24 * head.vertices + 16 * head.triangles;
    mesh::Mesh out;
    bool good = plausible;
    if (good) {
        take(body, out.vertices, head.vertices);
        take(body, out.triangles, head.triangles);
        take(body, out.faces, head.triangles);
        for (const auto& t : out.triangles)
            for (const auto v : t) good = good && v < head.vertices;
    }
    if (!good) throw Error(Exit::failure, "cannot use what the reader of STEP files says; build Filum again");
    return out;
}

Note left_out(NoteCode code, std::uint64_t count) { return {.code = code, .amount = 0, .count = count}; }

} // namespace

bool available() { return !reader().empty(); }

mesh::File read(std::string_view bytes, const std::string& name, const Tessellation& how, int plate) {
    if (mesh::recognise(bytes) != mesh::Kind::step) return mesh::read(bytes, name, plate);
    const fs::path program = reader();
    if (program.empty())
        throw Error(Exit::failure, "cannot read " + name +
                                       ": it is a STEP file, and this build has no OpenCASCADE; run scripts/setup "
                                       "--step and build again, or export the part as STL or 3MF");
    if (bytes.rfind("END-ISO-10303-21") == std::string_view::npos)
        throw Error(Exit::truncated,
                    "cannot read " + name + ": it ends before END-ISO-10303-21; copy or export it again");
    const Memory in, out;
    in.fill(bytes);
    const int status = run(program, how, in, out);
    const std::string answer = out.content();
    Answer head;
    if (WIFEXITED(status) && answer.size() >= sizeof head) std::memcpy(&head, answer.data(), sizeof head);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || answer.size() < sizeof head || head.mark != Answer::kMark)
        throw Error(Exit::bad_input,
                    "cannot read " + name + ": OpenCASCADE broke down on it" +
                        (WIFSIGNALED(status) ? " (signal " + std::to_string(WTERMSIG(status)) + ")" : "") +
                        ", it may be damaged; export it again, or as STL");
    const std::string_view body = std::string_view(answer).substr(sizeof head);
    if (head.failed != 0) throw Error(Exit::bad_input, "cannot read " + name + ": " + std::string(body));
    mesh::File file{.mesh = unpacked(head, body), .kind = mesh::Kind::step, .notes = {}};
    if (head.unread > 0) file.notes.push_back(left_out(NoteCode::cad_face_unread, head.unread));
    if (head.unmeshed > 0) {
        file.notes.push_back(left_out(NoteCode::cad_face_unmeshed, head.unmeshed));
        file.notes.back().x = head.x;
        file.notes.back().y = head.y;
    }
    return file;
}

} // namespace filum::mesh::step
