#include "ingest/origin.hpp"

namespace filum::ingest {

void Origin::name(std::size_t axis, double at, double number) {
    zero_[axis] = at - number - work_[system_][axis] - local_[axis];
}

void Origin::work(std::size_t system, std::size_t axis, double offset) {
    work_[system][axis] = offset;
    set_[system] = true;
}

void Origin::work_name(std::size_t system, std::size_t axis, double at, double number) {
    work(system, axis, at - number - zero_[axis] - local_[axis]);
}

} // namespace filum::ingest
