// Fuzzing by the structure of a message: bytes are decoded, some fields changed by their types, and encoded again, so
// that most inputs pass the parser and reach the stage.
#pragma once

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

namespace filum::fuzz {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;
using Random = std::mt19937;

inline std::size_t below(Random& r, std::size_t n) { return n == 0 ? 0 : r() % n; }

// A value near the old one in most cases, so that outlines stay outlines; else one of those that break things.
inline double changed(double old, Random& r) {
    constexpr std::array kOdd{0.0,
                              -0.0,
                              1e-300,
                              1e-9,
                              1e-3,
                              1.0,
                              1e3,
                              1e7,
                              1e8,
                              1.1e8,
                              1e308,
                              double(NAN),
                              double(INFINITY),
                              -double(INFINITY)};
    if (below(r, 3) == 0) return kOdd[below(r, kOdd.size())];
    const double by = static_cast<double>(below(r, 2001)) / 1000 - 1;
    constexpr std::array kScale{1e-4, 1e-2, 1.0, 10.0};
    return below(r, 4) == 0 ? -old : old + by * kScale[below(r, kScale.size())];
}

inline std::uint64_t changed(std::uint64_t old, Random& r) {
    constexpr std::array<std::uint64_t, 8> kOdd{0, 1, 2, 255, 65536, 0x7fffffff, 0xfffffffe, 0xffffffff};
    return below(r, 2) == 0 ? kOdd[below(r, kOdd.size())] : old + below(r, 5) - 2;
}

// Sets item `k` of a repeated field, or a single one (k < 0).
inline void change_scalar(Message& m, const FieldDescriptor* f, int k, Random& r) {
    const Reflection& g = *m.GetReflection();
    const bool one = k < 0;
    switch (f->cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE: {
        const double v = changed(one ? g.GetDouble(m, f) : g.GetRepeatedDouble(m, f, k), r);
        return one ? g.SetDouble(&m, f, v) : g.SetRepeatedDouble(&m, f, k, v);
    }
    case FieldDescriptor::CPPTYPE_UINT32: {
        const auto v = static_cast<std::uint32_t>(
            changed(std::uint64_t{one ? g.GetUInt32(m, f) : g.GetRepeatedUInt32(m, f, k)}, r));
        return one ? g.SetUInt32(&m, f, v) : g.SetRepeatedUInt32(&m, f, k, v);
    }
    case FieldDescriptor::CPPTYPE_INT32: {
        const auto v = static_cast<std::int32_t>(changed(std::uint64_t(below(r, 9)), r));
        return one ? g.SetInt32(&m, f, v) : g.SetRepeatedInt32(&m, f, k, v);
    }
    case FieldDescriptor::CPPTYPE_BOOL: {
        const bool v = below(r, 2) == 0;
        return one ? g.SetBool(&m, f, v) : g.SetRepeatedBool(&m, f, k, v);
    }
    case FieldDescriptor::CPPTYPE_ENUM: {
        const int v = static_cast<int>(below(r, 16)) - 1;
        return one ? g.SetEnumValue(&m, f, v) : g.SetRepeatedEnumValue(&m, f, k, v);
    }
    case FieldDescriptor::CPPTYPE_STRING: {
        const std::string v(below(r, 70), 'x');
        return one ? g.SetString(&m, f, v) : g.SetRepeatedString(&m, f, k, v);
    }
    default:
        return;
    }
}

// An item swapped with another one, or the last one dropped.
inline void change_list(Message& m, const FieldDescriptor* f, int n, Random& r) {
    const Reflection& g = *m.GetReflection();
    if (below(r, 3) == 0) return g.RemoveLast(&m, f);
    g.SwapElements(&m, f, static_cast<int>(below(r, static_cast<std::size_t>(n))),
                   static_cast<int>(below(r, static_cast<std::size_t>(n))));
}

inline void change(Message& m, Random& r) {
    const Reflection& g = *m.GetReflection();
    const auto* type = m.GetDescriptor();
    for (int tries = 0; tries < 20 && type->field_count() > 0; ++tries) {
        const FieldDescriptor* f =
            type->field(static_cast<int>(below(r, static_cast<std::size_t>(type->field_count()))));
        const bool message = f->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE;
        if (!f->is_repeated()) {
            if (!message) return change_scalar(m, f, -1, r);
            if (g.HasField(m, f)) return change(*g.MutableMessage(&m, f), r);
            continue;
        }
        const int n = g.FieldSize(m, f);
        if (n == 0) continue;
        const int k = static_cast<int>(below(r, static_cast<std::size_t>(n)));
        if (below(r, 5) == 0) return change_list(m, f, n, r);
        return message ? change(*g.MutableRepeatedMessage(&m, f, k), r) : change_scalar(m, f, k, r);
    }
}

// The body of LLVMFuzzerCustomMutator for messages of type M; `start` is a sound one, for input that is none.
template <class M>
std::size_t mutate(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed, const M& start) {
    Random r(seed);
    M m;
    if (size < 2 || !m.ParseFromArray(data, static_cast<int>(size)) || below(r, 50) == 0) m = start;
    for (std::size_t k = 1 + below(r, 3); k > 0; --k) change(m, r);
    const std::size_t bytes = m.ByteSizeLong();
    if (bytes > most) return size;
    m.SerializeToArray(data, static_cast<int>(bytes));
    return bytes;
}

} // namespace filum::fuzz
