#include "surfpath/surfpath.hpp"

#include "base/error.hpp"

namespace filum::surfpath {

Plan plan(const surface::Sheet&, const Options& options) {
    throw Error(Exit::usage, "cannot plan by '" + options.algorithm + "' yet");
}

} // namespace filum::surfpath
