#include "bgcode/heatshrink.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace filum::bgcode {

namespace {

class BitReader {
  public:
    explicit BitReader(std::string_view data) : data_(data) {}
    // Takes the next `bits` bits; none if fewer are left.
    std::optional<std::uint32_t> take(int bits) {
        if (at_ + static_cast<std::size_t>(bits) > 8 * data_.size()) return std::nullopt;
        std::uint32_t out = 0;
        for (int i = 0; i < bits; ++i, ++at_)
            out = 2 * out + ((static_cast<unsigned char>(data_[at_ / 8]) >> (7 - at_ % 8)) & 1U);
        return out;
    }

  private:
    std::string_view data_;
    std::size_t at_ = 0; // position in bits
};

class BitWriter {
  public:
    void put(std::uint32_t value, int bits) {
        for (int i = bits - 1; i >= 0; --i, ++at_) {
            if (at_ % 8 == 0) out_ += '\0';
            const unsigned bit = ((value >> i) & 1U) << (7 - at_ % 8);
            out_.back() = static_cast<char>(static_cast<unsigned char>(out_.back()) | bit);
        }
    }
    std::string take() { return std::move(out_); }

  private:
    std::string out_;
    std::size_t at_ = 0;
};

} // namespace

std::optional<std::string> expanded(std::string_view data, std::size_t size, int window_bits, int length_bits) {
    BitReader bits(data);
    std::string out;
    out.reserve(std::min(size, data.size() * (std::size_t{1} << length_bits)));
    while (out.size() < size) {
        const auto literal = bits.take(1);
        if (!literal) return std::nullopt;
        if (*literal == 1) {
            const auto byte = bits.take(8);
            if (!byte) return std::nullopt;
            out += static_cast<char>(*byte);
            continue;
        }
        const auto back = bits.take(window_bits), length = bits.take(length_bits);
        if (!back || !length || *back + 1 > out.size()) return std::nullopt;
        for (std::uint32_t i = 0; i <= *length && out.size() < size; ++i) out += out[out.size() - *back - 1];
    }
    return out;
}

std::string shrunk(std::string_view data, int window_bits, int length_bits) {
    constexpr std::size_t kHashes = std::size_t{1} << 15;
    constexpr int kMostTrials = 64; // earlier positions that are compared
    const std::size_t window = std::size_t{1} << window_bits, longest = std::size_t{1} << length_bits;
    const std::size_t least = static_cast<std::size_t>(1 + window_bits + length_bits) / 9 + 1; // shortest useful match
    constexpr std::uint32_t kNone = UINT32_MAX;
    std::vector<std::uint32_t> latest(kHashes, kNone), earlier(data.size(), kNone); // chains by hash
    const auto hash = [&](std::size_t i) {
        const auto byte = [&](std::size_t k) {
            return static_cast<std::uint32_t>(static_cast<unsigned char>(data[k]));
        };
        return (byte(i) * 2654435761U ^ byte(i + 1) * 40503U) % kHashes;
    };
    BitWriter out;
    for (std::size_t i = 0; i < data.size();) {
        std::size_t best = 0, back = 0;
        const std::size_t most = std::min(longest, data.size() - i);
        int trials = 0;
        for (std::uint32_t k = most >= 2 ? latest[hash(i)] : kNone;
             k != kNone && i - k <= window && trials < kMostTrials; k = earlier[k], ++trials) {
            std::size_t n = 0;
            while (n < most && data[k + n] == data[i + n]) ++n;
            if (n > best) best = n, back = i - k;
        }
        const std::size_t step = best >= least ? best : 1;
        if (step > 1) {
            out.put(0, 1);
            out.put(static_cast<std::uint32_t>(back - 1), window_bits);
            out.put(static_cast<std::uint32_t>(best - 1), length_bits);
        } else {
            out.put(1, 1);
            out.put(static_cast<unsigned char>(data[i]), 8);
        }
        for (std::size_t k = i; k < i + step; ++k) {
            if (k + 1 >= data.size()) break;
            earlier[k] = latest[hash(k)];
            latest[hash(k)] = static_cast<std::uint32_t>(k);
        }
        i += step;
    }
    return out.take();
}

} // namespace filum::bgcode
