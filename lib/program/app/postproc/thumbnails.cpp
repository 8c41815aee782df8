#include "app/postproc/thumbnails.hpp"

#include "base/base64.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "render/draw.hpp"
#include "wire/planar.hpp"

#include <cmath>
#include <sstream>

namespace filum::app::postproc {

namespace {

constexpr int kLeastSide = 8,
              kMostSide = 2000;   // pixels: smaller pictures show nothing, and no printer displays larger ones
constexpr std::size_t kLine = 78; // letters per line of base64, as readers expect

int side(const std::string& text, const std::string& word) {
    const double value = parse_number(text, "--thumbnails");
    if (!(value >= kLeastSide && value <= kMostSide) || value != std::floor(value))
        throw Error(Exit::usage, "cannot use '" + word + "' for --thumbnails: a side has " +
                                     std::to_string(kLeastSide) + " to " + std::to_string(kMostSide) + " pixels");
    return static_cast<int>(value);
}

} // namespace

std::vector<PictureSize> thumbnail_sizes(const std::string& text) {
    std::vector<PictureSize> out;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        const auto x = word.find('x');
        if (x == std::string::npos)
            throw Error(Exit::usage, "cannot use '" + word + "' for --thumbnails: it must be a size, as 220x124");
        out.push_back({side(word.substr(0, x), word), side(word.substr(x + 1), word)});
    }
    return out;
}

std::vector<std::string> thumbnails(stream::Spool& spool, const std::vector<PictureSize>& sizes, int threads) {
    render::Scene scene;
    while (const auto frame = spool.next()) render::add(scene, wire::span(*frame), {});
    std::vector<std::string> out;
    for (const PictureSize& size : sizes) {
        render::Options how;
        how.size = {static_cast<double>(size.width), static_cast<double>(size.height)};
        how.no_table = true;
        out.push_back(render::draw(scene, how, "progress", threads));
    }
    return out;
}

std::vector<std::string> thumbnail_lines(const std::vector<PictureSize>& sizes,
                                         const std::vector<std::string>& pictures) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const PictureSize& size = sizes[i];
        const std::string& png = pictures[i];
        const std::string text = base64({reinterpret_cast<const unsigned char*>(png.data()), png.size()});
        out.push_back(" thumbnail begin " + std::to_string(size.width) + "x" + std::to_string(size.height) + " " +
                      std::to_string(text.size()));
        for (std::size_t at = 0; at < text.size(); at += kLine) out.push_back(" " + text.substr(at, kLine));
        out.push_back(" thumbnail end");
    }
    return out;
}

} // namespace filum::app::postproc
