#include "wire/json.hpp"

#include "base/number.hpp"

#include <google/protobuf/struct.pb.h>
#include <google/protobuf/util/json_util.h>

namespace filum::wire {

namespace {

std::string text_of(const google::protobuf::Value& v) {
    if (v.has_list_value()) {
        std::string out;
        for (const auto& item : v.list_value().values()) out += (out.empty() ? "" : ",") + text_of(item);
        return out;
    }
    if (v.has_number_value()) return shortest_text(v.number_value());
    if (v.has_bool_value()) return v.bool_value() ? "1" : "0";
    return v.string_value();
}

} // namespace

std::map<std::string, std::string> json_values(const std::string& text) {
    google::protobuf::Struct all;
    std::map<std::string, std::string> out;
    if (!google::protobuf::util::JsonStringToMessage(text, &all).ok()) return out;
    for (const auto& [key, value] : all.fields()) out[key] = text_of(value);
    return out;
}

} // namespace filum::wire
