#include "app/filum/show.hpp"

#include "stream/sink.hpp"

#include <algorithm>

namespace filum::app::filum {

void show(const std::string& text) {
    stream::Sink out("-", stream::Sink::Content::text);
    out.write(text);
    out.commit();
}

std::string cell(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 2, width), ' ');
    return text;
}

} // namespace filum::app::filum
