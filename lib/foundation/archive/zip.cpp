#include "archive/zip.hpp"

#include "base/error.hpp"

#include <zip.h>

namespace filum::archive {

struct Zip::Handle {
    std::unique_ptr<zip_t, void (*)(zip_t*)> zip{nullptr, [](zip_t* z) { zip_discard(z); }};
};

void Zip::bad(const std::string& why) const { throw Error(Exit::bad_input, "cannot read " + name_ + ": " + why); }

bool Zip::begins(std::string_view bytes) { return bytes.starts_with("PK\003\004"); }

Zip::Zip(std::string_view bytes, std::string name, Names names)
    : handle_(std::make_unique<Handle>()), name_(std::move(name)) {
    const int flags = names == Names::of_both_places ? ZIP_RDONLY | ZIP_CHECKCONS : ZIP_RDONLY;
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source != nullptr) handle_->zip.reset(zip_open_from_source(source, flags, &error));
    const std::string why = zip_error_strerror(&error);
    zip_error_fini(&error);
    if (handle_->zip != nullptr) return;
    if (source != nullptr) zip_source_free(source);
    bad("it is no whole zip archive: " + why);
}

Zip::~Zip() = default;

bool Zip::has(const std::string& path) const {
    return zip_name_locate(handle_->zip.get(), path.c_str(), ZIP_FL_NOCASE) >= 0;
}

std::vector<std::string> Zip::entries() const {
    zip_t* zip = handle_->zip.get();
    std::vector<std::string> out;
    for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0); ++i)
        if (const char* entry = zip_get_name(zip, static_cast<zip_uint64_t>(i), 0); entry != nullptr)
            out.emplace_back(entry);
    return out;
}

std::string Zip::read(std::string path) {
    zip_t* zip = handle_->zip.get();
    if (path.starts_with('/')) path.erase(0, 1);
    const zip_int64_t index = zip_name_locate(zip, path.c_str(), ZIP_FL_NOCASE);
    if (index < 0) bad("'" + path + "' is missing in the archive");
    const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> f(
        zip_fopen_index(zip, static_cast<zip_uint64_t>(index), 0), &zip_fclose);
    if (f == nullptr) bad("'" + path + "' in the archive cannot be opened: " + zip_strerror(zip));
    std::string out;
    constexpr std::size_t kStep = std::size_t{1} << 20;
    for (;;) { // reads in steps, as the size that the archive states may be wrong
        const std::size_t had = out.size();
        out.resize(had + kStep);
        const zip_int64_t n = zip_fread(f.get(), out.data() + had, kStep);
        if (n < 0) bad("'" + path + "' in the archive is damaged: " + zip_file_strerror(f.get()));
        out.resize(had + static_cast<std::size_t>(n));
        if (n == 0) return out;
        if (taken_ += static_cast<std::size_t>(n); taken_ > kMost) bad("it holds more than 512 MiB");
    }
}

namespace {

[[noreturn]] void cannot_write(const std::string& why) {
    throw Error(Exit::failure, "cannot write a zip archive: " + why);
}

using Target = std::unique_ptr<zip_source_t, decltype(&zip_source_free)>;

// The bytes that libzip has written to `target`.
std::string bytes_of(zip_source_t* target) {
    zip_stat_t about;
    zip_stat_init(&about);
    if (zip_source_stat(target, &about) != 0 || zip_source_open(target) != 0) cannot_write("its bytes are not there");
    std::string out(about.size, '\0');
    const zip_int64_t n = zip_source_read(target, out.data(), out.size());
    zip_source_close(target);
    if (n < 0 || static_cast<std::size_t>(n) != out.size()) cannot_write("its bytes are not whole");
    return out;
}

void add_file(zip_t* zip, const std::string& path, const std::string& content) {
    zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
    if (source == nullptr) cannot_write(zip_strerror(zip));
    const zip_int64_t index = zip_file_add(zip, path.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        cannot_write(path + ": " + zip_strerror(zip));
    }
    constexpr zip_uint16_t kFirstDay = 1U << 5U | 1U; // month and day of the year 1980
    const auto entry = static_cast<zip_uint64_t>(index);
    if (zip_set_file_compression(zip, entry, ZIP_CM_DEFLATE, 0) != 0 ||
        zip_file_set_dostime(zip, entry, 0, kFirstDay, 0) != 0)
        cannot_write(path + ": " + zip_strerror(zip));
}

} // namespace

std::string zipped(const std::vector<std::pair<std::string, std::string>>& files) {
    zip_error_t error;
    zip_error_init(&error);
    const Target target(zip_source_buffer_create(nullptr, 0, 0, &error), &zip_source_free);
    if (target == nullptr) cannot_write(zip_error_strerror(&error));
    zip_source_keep(target.get()); // a second reference: zip_close releases one
    std::unique_ptr<zip_t, decltype(&zip_discard)> zip(
        zip_open_from_source(target.get(), ZIP_CREATE | ZIP_TRUNCATE, &error), &zip_discard);
    if (zip == nullptr) {
        zip_source_free(target.get());
        cannot_write(zip_error_strerror(&error));
    }
    for (const auto& [path, content] : files) add_file(zip.get(), path, content);
    if (zip_close(zip.get()) != 0) cannot_write(zip_strerror(zip.get()));
    (void)zip.release(); // zip_close freed it
    return bytes_of(target.get());
}

} // namespace filum::archive
