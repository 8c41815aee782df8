// Writes zip archives, for shapes.hpp.
#include "shapes.hpp"

#include <zip.h>

namespace shapes {

std::string archive(const std::string& model, const std::map<std::string, std::string>& others) {
    const std::string rels = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                             "<Relationship Target=\"/3D/3dmodel.model\" Id=\"r\" "
                             "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* memory = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(memory);
    zip_t* zip = zip_open_from_source(memory, ZIP_TRUNCATE, &error);
    for (const auto& [name, content] : {std::pair{"_rels/.rels", &rels}, std::pair{"3D/3dmodel.model", &model}})
        zip_file_add(zip, name, zip_source_buffer(zip, content->data(), content->size(), 0), 0);
    for (const auto& [name, content] : others)
        zip_file_add(zip, name.c_str(), zip_source_buffer(zip, content.data(), content.size(), 0), 0);
    zip_close(zip);
    std::string out;
    zip_source_open(memory);
    char b[4096];
    for (zip_int64_t n = 0; (n = zip_source_read(memory, b, sizeof b)) > 0;) out.append(b, static_cast<std::size_t>(n));
    zip_source_close(memory);
    zip_source_free(memory);
    return out;
}

} // namespace shapes
