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

std::string Zip::find(const std::function<bool(std::string_view)>& fits) const {
    zip_t* zip = handle_->zip.get();
    for (zip_int64_t i = 0; i < zip_get_num_entries(zip, 0); ++i)
        if (const char* entry = zip_get_name(zip, static_cast<zip_uint64_t>(i), 0); entry != nullptr && fits(entry))
            return entry;
    return "";
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
    for (;;) { // the size that the archive states is no promise
        const std::size_t had = out.size();
        out.resize(had + kStep);
        const zip_int64_t n = zip_fread(f.get(), out.data() + had, kStep);
        if (n < 0) bad("'" + path + "' in the archive is damaged: " + zip_file_strerror(f.get()));
        out.resize(had + static_cast<std::size_t>(n));
        if (n == 0) return out;
        if (taken_ += static_cast<std::size_t>(n); taken_ > kMost) bad("it holds more than 512 MiB");
    }
}

} // namespace filum::archive
